// Perpendicular directions and rotations.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace panicle {

// A coordinate axis that a unit vector does not follow: `first`, or `second` where the cosine of the angle to the line
// of `first` is `limit` or more.
inline glm::vec3 axis_across(const glm::vec3& way, float limit = 0.9f, const glm::vec3& first = {0, 1, 0},
                             const glm::vec3& second = {1, 0, 0}) {
  return std::fabs(glm::dot(way, first)) < limit ? first : second;
}

// A unit vector at right angles to a unit vector, and to the coordinate axis that axis_across returns.
inline glm::vec3 any_perpendicular(const glm::vec3& way, float limit = 0.9f, const glm::vec3& first = {0, 1, 0},
                                   const glm::vec3& second = {1, 0, 0}) {
  return glm::normalize(glm::cross(way, axis_across(way, limit, first, second)));
}

// The rotation of a right-handed orthonormal frame as a unit quaternion x y z w (Shepperd 1978).
inline glm::vec4 quaternion_of(const glm::mat3& frame) {
  const float trace = frame[0][0] + frame[1][1] + frame[2][2];
  glm::vec4 q;
  if (trace > 0) {
    q = {frame[1][2] - frame[2][1], frame[2][0] - frame[0][2], frame[0][1] - frame[1][0], 1 + trace};
  } else {
    int i = 0;
    for (int k = 1; k < 3; ++k)
      if (frame[k][k] > frame[i][i]) i = k;
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    q[i] = 1 + frame[i][i] - frame[j][j] - frame[k][k];
    q[j] = frame[j][i] + frame[i][j];
    q[k] = frame[k][i] + frame[i][k];
    q.w = frame[j][k] - frame[k][j];
  }
  return q / glm::length(q);
}

// The rotation that takes +Y to `up` and +Z to `front`, unit vectors at right angles, as a unit quaternion x y z w.
// Sums follow the order of the axes, unlike those of quaternion_of: models/growth/leaf_poses.cpp computes the same in
// lanes, and the last bits of leaves' rotations depend on it.
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
