// Closest points of two straight segments (Ericson 2005, Real-Time Collision Detection, section 5.1.9).
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace panicle {

// A segment: the points at middle + way · s with |s| ≤ reach.
struct Extent {
  glm::vec3 way{0};
  float reach = 0;
  float square = 1;  // of way's length
};

// The closest points of two segments: s on the first, t on the second.
struct Closest {
  float s, t;
};

// `between` leads from the first's middle to the second's. Where the sine of their angle is below √`parallel` the
// search starts at the first segment's middle, so that the result for parallel segments does not jump from end to end.
inline Closest closest_points(const glm::vec3& between, const Extent& a, const Extent& b, float parallel) {
  const float ab = glm::dot(a.way, b.way), da = glm::dot(a.way, between), db = glm::dot(b.way, between);
  const float apart = a.square * b.square - ab * ab;
  float s =
      apart > parallel * a.square * b.square ? std::clamp((da * b.square - ab * db) / apart, -a.reach, a.reach) : 0;
  const float t = b.square > 0 ? std::clamp((ab * s - db) / b.square, -b.reach, b.reach) : 0;
  if (a.square > 0) s = std::clamp((ab * t + da) / a.square, -a.reach, a.reach);
  return {s, t};
}

}  // namespace panicle
