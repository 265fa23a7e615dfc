// Perpendicular directions and rotations.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace panicle {

// A vector at right angles to a unit vector.
inline glm::vec3 any_perpendicular(const glm::vec3& way) {
  return glm::normalize(glm::cross(way, std::fabs(way.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
}

// The rotation that takes +Y to `up` and +Z to `front`, unit and at right angles, as a quaternion (Shepperd 1978).
inline glm::vec4 turn_to(const glm::vec3& up, const glm::vec3& front) {
  const glm::vec3 side = glm::cross(up, front);
  const float trace = side.x + up.y + front.z;
  glm::vec4 q;
  if (trace > 0)
    q = {up.z - front.y, front.x - side.z, side.y - up.x, 1 + trace};
  else if (side.x > up.y && side.x > front.z)
    q = {1 + side.x - up.y - front.z, up.x + side.y, front.x + side.z, up.z - front.y};
  else if (up.y > front.z)
    q = {up.x + side.y, 1 - side.x + up.y - front.z, front.y + up.z, front.x - side.z};
  else
    q = {front.x + side.z, front.y + up.z, 1 - side.x - up.y + front.z, side.y - up.x};
  return q / glm::length(q);
}

}  // namespace panicle
