// A closed surface of triangles, and the forms it is made in.
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
// A profile of radii and heights, x ≥ 0, y ascending, turned about the upright axis through `foot`; its ends are
// closed.
Surface surface_of_revolution(std::span<const glm::vec2> profile, const glm::vec3& foot, std::uint32_t sides);
Surface ellipsoid(const glm::vec3& centre, const glm::vec3& radii, std::uint32_t sides);
// The surface about a point, smaller or larger.
Surface scaled(const Surface& surface, const glm::vec3& about, float factor);

// Stretched so that its box is another; flat ways of it lie in the middle.
Surface stretched(Surface surface, const glm::vec3& low, const glm::vec3& high);
// Adds another's triangles.
void append(Surface& surface, const Surface& other);

// Where a surface is not closed. Points at the same place count as one.
struct Seams {
  std::size_t open = 0;    // edges with an odd number of triangles
  std::size_t turned = 0;  // edges that are run through more often one way than the other
};
Seams seams_of(const Surface& surface);

}  // namespace panicle
