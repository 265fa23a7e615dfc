// The visible sky of the parts of a plant: stems and meshes. Each part hides sky from others, and receives some.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "light/sky.hpp"
#include "stems/segment.hpp"
#include "stems/tubes.hpp"

namespace panicle {

// The body of a ball.
inline SkyBody sky_ball(const glm::vec3& centre, float radius, std::int32_t owner) {
  return {centre, radius * radius, glm::vec3(0), owner};
}

// Adds the bodies that approximate a segment, in pieces no longer than eight times its thickness.
void add_specks(const Segment& segment, std::int32_t owner, std::vector<SkyBody>& specks);

// Adds the bodies that approximate a part: groups of its triangles. A flat group, as in a leaf, hides sky depending on
// the side it is seen from; a round one, as in a tube, does not.
void add_specks(const Mesh& mesh, const MeshRange& part, std::int32_t owner, std::vector<SkyBody>& specks);

// Returns the sky of each vertex of a skin swept over `segments`, whose indices are the owners.
std::vector<std::uint8_t> sky_of_stems(Sky& sky, const StemMesh& stems, std::span<const Segment> segments);

// Computes the sky of a part's vertices (of a sheet, which is lit from both sides, the better of the two), and writes
// it to their places in `bytes`, which has one byte a vertex of the mesh.
void sample_part(Sky& sky, const Mesh& mesh, const MeshRange& part, std::int32_t owner, bool sheet,
                 std::span<std::uint8_t> bytes);

}  // namespace panicle
