// A sheet of triangles as a plate: closed, with walls along its edges.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace panicle::grammar {

// Adds a plate to a mesh whose texture coordinates are still to be put: `from` tells of each vertex that is added which
// corner it is of. Triangles are of corners, three each; they lie in the middle of the plate, half a thickness from
// either face, so that its volume is their area times the thickness where that is small beside their bends. Each edge
// of the plate is run through as often one way as the other: twice in all where the sheet does not touch itself.
void add_plate(Mesh& mesh, std::span<const glm::vec3> corners, std::span<const std::uint32_t> triangles,
               float thickness, std::vector<std::uint32_t>& from);

}  // namespace panicle::grammar
