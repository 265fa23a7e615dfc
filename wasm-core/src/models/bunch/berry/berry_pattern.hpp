// The pattern of vertices that the surfaces of all berries of a bunch follow.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace panicle::bunch {

// Rings of vertices about the axis from the tip (+Y) to the seat, fewer towards both, so that triangles have similar
// sizes everywhere; each is closed by a vertex at u = 1 on top of that at u = 0, and poles are doubled for u. All
// arrays are padded to a multiple of four by copies of the last vertex, for SIMD work on four at once.
struct BerryPattern {
  std::uint32_t vertices = 0;
  std::array<std::vector<float>, 3> directions;  // x, y, z of unit vectors from the centre
  std::vector<float> shares;                     // solid angle of the vertex; 0 in the padding
  std::vector<float> cells;                      // a sixth of the product of three directions, one a triangle
  std::vector<float> uvs;
  std::vector<std::uint32_t> indices;

  std::uint32_t padded() const { return static_cast<std::uint32_t>(shares.size()); }
};

// `meridians` is the number of segments round the widest ring, 8 … 320.
BerryPattern make_berry_pattern(std::uint32_t meridians);

}  // namespace panicle::bunch
