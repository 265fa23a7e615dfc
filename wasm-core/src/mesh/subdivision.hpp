// Closed surfaces of polygons as half-edges, and their subdivision (Catmull and Clark 1978, "Recursively generated
// B-spline surfaces on arbitrary topological meshes"). Nothing has a border, so no case is special.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace panicle {

// A half-edge runs from its origin along its face, which lies to its left seen from outside.
struct ClosedSurface {
  std::vector<std::uint32_t> origin, next, twin, face;  // of half-edges
  std::vector<glm::vec3> positions;                     // of vertices
  std::uint32_t faces = 0;

  std::uint32_t half_edges() const { return static_cast<std::uint32_t>(origin.size()); }
};

// The topology of the subdivided surface; its vertices have no positions yet. Each half-edge becomes a quad of the same
// number: from its origin over its own middle and the face's to the middle of the half-edge before. Vertices keep their
// numbers; those of edges and faces come behind them.
ClosedSurface refined(const ClosedSurface& surface);
// Computes the positions of the subdivided surface's vertices from those of `surface`.
void place_refined(const ClosedSurface& surface, ClosedSurface& fine);
// Subdivides topology and positions.
ClosedSurface subdivided(const ClosedSurface& surface);

// The positions of the surface's own vertices after one subdivision.
std::vector<glm::vec3> rounded_vertices(const ClosedSurface& surface);

// Unit normals of the vertices: the area-weighted mean of the faces around them.
std::vector<glm::vec3> normals_of(const ClosedSurface& surface);

}  // namespace panicle
