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

// How a finer surface hangs together; its vertices have no places yet. Each half-edge becomes a quad, with its number:
// from its origin over its own middle and the face's to the middle of the half-edge before. Vertices keep their
// numbers; those of edges and faces come behind them.
ClosedSurface refined(const ClosedSurface& surface);
// Where its vertices are, by where those of the surface are that it is refined from.
void place_refined(const ClosedSurface& surface, ClosedSurface& fine);
// Both.
ClosedSurface subdivided(const ClosedSurface& surface);

// Where its own vertices come to lie when it is subdivided once, without those that come between.
std::vector<glm::vec3> rounded_vertices(const ClosedSurface& surface);

// Unit normals of the vertices: of the faces about them, by their area.
std::vector<glm::vec3> normals_of(const ClosedSurface& surface);

}  // namespace panicle
