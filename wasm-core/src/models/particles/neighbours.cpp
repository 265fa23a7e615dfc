#include "models/particles/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "foundation/lanes.hpp"
#include "foundation/mathematics.hpp"

namespace panicle::particles {
namespace {

constexpr std::uint32_t lanes = 4;

// The approximate distance of neighbours where `count` points fill a box evenly. A box that is flat in one or two
// directions counts as a plane or a line.
float mean_spacing(const glm::vec3& size, std::size_t count) {
  const float largest = std::max({size.x, size.y, size.z});
  if (!(largest > 0)) return 1;
  float filled = 1;
  int dimensions = 0;
  for (const float extent : {size.x, size.y, size.z}) {
    if (extent < 1e-3f * largest) continue;
    filled *= extent / largest;
    ++dimensions;
  }
  filled /= static_cast<float>(count);
  return largest * (dimensions == 3 ? cube_root(filled) : dimensions == 2 ? std::sqrt(filled) : filled);
}

}  // namespace

// Sorts the points into a grid, with their coordinates in separate arrays for four at a time. `points` must outlive the
// queries.
void Neighbours::build(std::span<const glm::vec3> points) {
  points_ = points;
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  for (const glm::vec3& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  // A little more, so that its square is not rounded below that of two points at opposite corners.
  across_ = points.empty() ? 0 : 1.001f * glm::distance(low, high);
  edge_ = mean_spacing(high - low, points.size());
  grid_.build(points, edge_);
  const std::span<const std::uint32_t> ids = grid_.ids();
  for (auto* values : {&x_, &y_, &z_}) values->resize(ids.size() + lanes - 1);
  for (std::size_t slot = 0; slot < ids.size(); ++slot) {
    const glm::vec3& p = points[ids[slot]];
    x_[slot] = p.x;
    y_[slot] = p.y;
    z_[slot] = p.z;
  }
}

// The nearest other point that point i sees, within `reach`; `none` if there is none. Ties go to the lower index.
std::uint32_t Neighbours::nearest(std::uint32_t i, float reach, const Guide& guide) const {
  const glm::vec3 p = points_[i];
  const std::uint32_t* ids = grid_.ids().data();
  const float farthest = std::min(reach, across_);
  std::uint32_t found = none;
  float best = 0;
  // A box twice as wide each time: the nearest point in the ball inside it is certain.
  for (float half = 0.75f * edge_;; half *= 2) {
    half = std::min(half, farthest);
    best = half * half;
    found = none;
    grid_.within(p - half, p + half, [&](std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t slot = first; slot < end; slot += lanes) {
        const Four x = load(&x_[slot]) - p.x, y = load(&y_[slot]) - p.y, z = load(&z_[slot]) - p.z;
        const Four square = x * x + y * y + z * z;
        const auto near = square <= best;
        if (all(~near)) continue;
        const std::uint32_t count = std::min(end - slot, lanes);
        for (std::uint32_t lane = 0; lane < count; ++lane) {
          const std::uint32_t other = ids[slot + lane];
          if (!(square[lane] <= best) || other == i) continue;
          if (square[lane] == best && found != none && found < other) continue;
          if (!guide.sees(p, points_[other])) continue;
          best = square[lane];
          found = other;
        }
      }
    });
    if (found != none || half >= farthest) return found;
  }
}

// Adds all pairs of points closer than `reach`, with their squared distances.
void Neighbours::pairs(float reach, std::vector<Pair>& found) const {
  const std::uint32_t* ids = grid_.ids().data();
  for (std::uint32_t a = 0; a < points_.size(); ++a) {
    const glm::vec3 p = points_[a];
    grid_.within(p - reach, p + reach, [&](std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t slot = first; slot < end; slot += lanes) {
        const Four x = load(&x_[slot]) - p.x, y = load(&y_[slot]) - p.y, z = load(&z_[slot]) - p.z;
        const Four square = x * x + y * y + z * z;
        const auto near = square < reach * reach;
        if (all(~near)) continue;
        const std::uint32_t count = std::min(end - slot, lanes);
        for (std::uint32_t lane = 0; lane < count; ++lane)
          if (near[lane] && a < ids[slot + lane]) found.push_back({square[lane], a, ids[slot + lane]});
      }
    });
  }
}

}  // namespace panicle::particles
