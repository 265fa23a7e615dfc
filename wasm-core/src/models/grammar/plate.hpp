// A sheet of triangles as a plate: closed, with walls along its edges.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace panicle::grammar {

// `v` at unit length, or `otherwise` if it is zero. Scales `v` first, so that its square is not too small for a float.
glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise);

// Adds a plate to a mesh, without texture coordinates; `from` gets the corner of each added vertex. Triangles have
// three corners each and lie in the middle of the plate, half a thickness from either face, so that its volume is their
// area times the thickness where the thickness is small beside the bends. The plate is closed: each edge is run through
// as often in one direction as in the other, twice in all where the sheet does not touch itself.
void add_plate(Mesh& mesh, std::span<const glm::vec3> corners, std::span<const std::uint32_t> triangles,
               float thickness, std::vector<std::uint32_t>& from);

}  // namespace panicle::grammar
