#include "models/particles/obstacles.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace panicle::particles {
namespace {

// Corners to turn at are placed about an ellipsoid at this multiple of its size: lines between neighbouring corners, up
// to 35° apart, keep clear of it.
constexpr float about_round = 1.1f;
constexpr int pieces = 4;  // of an edge, with a place to turn at between two

// Whether a point is inside a box; its faces are outside.
bool inside(const Box& box, const glm::vec3& p) {
  for (int k = 0; k < 3; ++k)
    if (!(p[k] > box.low[k] && p[k] < box.high[k])) return false;
  return true;
}

// Whether the segment from a to b meets a box, by the slab test: intersects the parameter ranges in which the segment
// lies between each pair of opposite faces.
bool segment_meets_box(const Box& box, const glm::vec3& a, const glm::vec3& b) {
  float first = 0, last = 1;
  for (int k = 0; k < 3; ++k) {
    const float way = b[k] - a[k];
    if (way == 0) {
      if (!(a[k] > box.low[k] && a[k] < box.high[k])) return false;
      continue;
    }
    const float to_low = (box.low[k] - a[k]) / way, to_high = (box.high[k] - a[k]) / way;
    first = std::max(first, std::min(to_low, to_high));
    last = std::min(last, std::max(to_low, to_high));
  }
  return first < last;
}

// The point relative to the middle of the ellipsoid that fills a box, in units of its half-axes: inside, the length is
// below 1. An ellipsoid without extent contains nothing.
glm::vec3 in_half_axes(const Box& box, const glm::vec3& p) {
  const glm::vec3 half = glm::max(0.5f * (box.high - box.low), glm::vec3(1e-6f));
  return (p - 0.5f * (box.low + box.high)) / half;
}

// Whether the segment from a to b meets an ellipsoid: tests the point of it that is nearest to the middle, in
// half-axes.
bool segment_meets_ellipsoid(const Box& box, const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 from = in_half_axes(box, a), way = in_half_axes(box, b) - from;
  const float square = glm::dot(way, way);
  const float at = square > 0 ? glm::clamp(-glm::dot(from, way) / square, 0.0f, 1.0f) : 0;
  const glm::vec3 nearest = from + at * way;
  return glm::dot(nearest, nearest) < 1;
}

}  // namespace

// Whether a point is inside the ellipsoid that fills the box.
bool within_round(const Box& box, const glm::vec3& p) {
  const glm::vec3 from = in_half_axes(box, p);
  return glm::dot(from, from) < 1;
}

// Widens all obstacles by `margin` and lists the free corners around them at which a way can turn, at heights between
// `floor` and `ceiling`. `rounds` are the boxes of ellipsoids.
Obstacles::Obstacles(std::span<const Box> boxes, std::span<const Box> rounds, float margin, float floor, float ceiling)
    : margin_(margin) {
  for (const Box& box : boxes) boxes_.push_back({box.low - margin, box.high + margin});
  for (const Box& box : rounds) rounds_.push_back({box.low - margin, box.high + margin});
  const auto turn_at = [&](const glm::vec3& p) {
    if (p.y >= floor && p.y <= ceiling && !contains(p)) corners_.push_back(p);
  };
  for (const Box& box : boxes_) {
    // A little off the faces, which do not count as inside.
    const glm::vec3 low = box.low - 0.1f * margin, size = box.high + 0.1f * margin - low;
    for (int z = 0; z <= pieces; ++z)
      for (int y = 0; y <= pieces; ++y)
        for (int x = 0; x <= pieces; ++x) {
          const int ends = (x % pieces == 0) + (y % pieces == 0) + (z % pieces == 0);
          if (ends >= 2) turn_at(low + size * glm::vec3(x, y, z) / static_cast<float>(pieces));
        }
  }
  for (const Box& box : rounds_) {
    const glm::vec3 middle = 0.5f * (box.low + box.high), half = 0.5f * (box.high - box.low);
    for (int z = -2; z <= 2; ++z)
      for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x)
          if (std::max({x * x, y * y, z * z}) == 4)
            turn_at(middle + about_round * half * glm::normalize(glm::vec3(x, y, z)));
  }
}

// Whether a point is inside an obstacle, with its margin.
bool Obstacles::contains(const glm::vec3& p) const {
  return std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& box) { return inside(box, p); }) ||
         std::any_of(rounds_.begin(), rounds_.end(), [&](const Box& box) { return within_round(box, p); });
}

// Whether an obstacle meets the segment from a to b.
bool Obstacles::between(const glm::vec3& a, const glm::vec3& b) const {
  return std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& box) { return segment_meets_box(box, a, b); }) ||
         std::any_of(rounds_.begin(), rounds_.end(),
                     [&](const Box& box) { return segment_meets_ellipsoid(box, a, b); });
}

}  // namespace panicle::particles
