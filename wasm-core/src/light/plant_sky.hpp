// The sky of what plants are made of: stems, and whatever is a mesh. Each hides some, and each sees some.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "light/sky.hpp"
#include "stems/segment.hpp"
#include "stems/tubes.hpp"

namespace panicle {

// A ball as a body.
inline SkyBody sky_ball(const glm::vec3& centre, float radius, std::int32_t owner) {
  return {centre, radius * radius, glm::vec3(0), owner};
}

// Adds what a segment hides, in pieces no longer than eight times its thickness.
void add_specks(const Segment& segment, std::int32_t owner, std::vector<SkyBody>& specks);

// A part of a mesh: runs of its arrays.
struct MeshPart {
  std::uint32_t first_vertex = 0, vertex_count = 0;
  std::uint32_t first_index = 0, index_count = 0;
};

// Adds what a part hides: its triangles, some at a time. Where they lie flat, as in a leaf, what they hide depends on
// the side they are seen from; where they go round, as in a tube, it does not.
void add_specks(const Mesh& mesh, const MeshPart& part, std::int32_t owner, std::vector<SkyBody>& specks);

// A byte a vertex of a skin swept over `segments`, whose indices are the owners.
std::vector<std::uint8_t> sky_of_stems(Sky& sky, const StemMesh& stems, std::span<const Segment> segments);

// The bytes of a part's vertices (of a sheet, which is lit from both sides, the better of the two), written where they
// stand in `bytes`, which has one a vertex of the mesh.
void sample_part(Sky& sky, const Mesh& mesh, const MeshPart& part, std::int32_t owner, bool sheet,
              std::span<std::uint8_t> bytes);

}  // namespace panicle
