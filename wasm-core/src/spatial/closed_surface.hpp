// Closed surfaces of triangles, and functions that make them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace panicle {

struct Surface {
  std::vector<glm::vec3> points;
  std::vector<std::uint32_t> triangles;  // 3 each, counter-clockwise from outside
};

Surface box(const glm::vec3& low, const glm::vec3& high);
// A surface of revolution: a profile of radii and heights, x ≥ 0, y ascending, around the upright axis through `foot`,
// with closed ends.
Surface surface_of_revolution(std::span<const glm::vec2> profile, const glm::vec3& foot, std::uint32_t sides);
Surface ellipsoid(const glm::vec3& centre, const glm::vec3& radii, std::uint32_t sides);
// The surface, scaled about a point.
Surface scaled(const Surface& surface, const glm::vec3& about, float factor);

// The surface, stretched so that its box is another; flat directions of it lie in the middle.
Surface stretched(Surface surface, const glm::vec3& low, const glm::vec3& high);
// Adds the triangles of another surface.
void append(Surface& surface, const Surface& other);

// Edges where a surface is not closed. Points at the same place count as one.
struct Seams {
  std::size_t open = 0;    // edges with an odd number of triangles
  std::size_t turned = 0;  // edges that are run through more often one way than the other
};
Seams seams_of(const Surface& surface);

}  // namespace panicle
