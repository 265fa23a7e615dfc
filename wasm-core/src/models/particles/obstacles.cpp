#include "models/particles/obstacles.hpp"

#include <algorithm>
#include <glm/common.hpp>

namespace panicle::particles {
namespace {

constexpr int pieces = 4;  // of an edge, with a place to turn at between two

bool inside(const Box& box, const glm::vec3& p) {
  for (int k = 0; k < 3; ++k)
    if (!(p[k] > box.low[k] && p[k] < box.high[k])) return false;
  return true;
}

// By slabs: the stretch of the way that lies between the planes of each pair of faces.
bool meets(const Box& box, const glm::vec3& a, const glm::vec3& b) {
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

}  // namespace

Obstacles::Obstacles(std::span<const Box> boxes, float margin, float floor, float ceiling) {
  for (const Box& box : boxes) boxes_.push_back({box.low - margin, box.high + margin});
  for (const Box& box : boxes_) {
    // A little off the faces, which do not count as inside.
    const glm::vec3 low = box.low - 0.1f * margin, size = box.high + 0.1f * margin - low;
    for (int z = 0; z <= pieces; ++z)
      for (int y = 0; y <= pieces; ++y)
        for (int x = 0; x <= pieces; ++x) {
          const int ends = (x % pieces == 0) + (y % pieces == 0) + (z % pieces == 0);
          if (ends < 2) continue;
          const glm::vec3 p = low + size * glm::vec3(x, y, z) / static_cast<float>(pieces);
          if (p.y >= floor && p.y <= ceiling && !contains(p)) corners_.push_back(p);
        }
  }
}

bool Obstacles::contains(const glm::vec3& p) const {
  return std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& box) { return inside(box, p); });
}

bool Obstacles::between(const glm::vec3& a, const glm::vec3& b) const {
  return std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& box) { return meets(box, a, b); });
}

}  // namespace panicle::particles
