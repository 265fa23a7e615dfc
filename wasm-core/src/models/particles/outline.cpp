#include "models/particles/outline.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace panicle::particles {
namespace {

constexpr float cells_along = 64;
// From a cell's middle to its corner, and what the nearest edge found may be too far.
constexpr float uncertain = 0.75f + 1;

float cross(const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; }

// Whether two segments cross or touch.
bool meet(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c, const glm::vec2& d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x)) return false;
  if (std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) return false;
  const float c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const float a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  return !((c_side > 0 && d_side > 0) || (c_side < 0 && d_side < 0) || (a_side > 0 && b_side > 0) ||
           (a_side < 0 && b_side < 0));
}

}  // namespace

Outline::Outline(std::vector<glm::vec2> points) : points_(std::move(points)) {
  if (points_.empty()) points_.push_back({0, 0});
  glm::vec2 low = points_[0], high = low;
  for (const glm::vec2& p : points_) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  low_ = {low.x, low.y, 0};
  high_ = {high.x, high.y, 0};
  const std::size_t rows = points_.size();
  row_height_ = std::max((high.y - low.y) / static_cast<float>(rows), std::numeric_limits<float>::min());
  const auto reach = [this](std::size_t i) {
    const float from = points_[i].y, to = points_[(i + 1) % points_.size()].y;
    return std::pair(row_of(std::min(from, to)), row_of(std::max(from, to)));
  };
  first_.assign(rows + 1, 0);
  for (std::size_t i = 0; i < points_.size(); ++i)
    for (auto [row, last] = reach(i); row <= last; ++row) ++first_[row + 1];
  for (std::size_t row = 0; row < rows; ++row) first_[row + 1] += first_[row];
  members_.resize(first_[rows]);
  std::vector<std::uint32_t> free(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < points_.size(); ++i)
    for (auto [row, last] = reach(i); row <= last; ++row) members_[free[row]++] = i;
  measure();
}

std::size_t Outline::row_of(float y) const {
  const float at = (y - low_.y) / row_height_;
  return static_cast<std::size_t>(std::clamp(at, 0.0f, static_cast<float>(points_.size() - 1)));
}

// Calls `see(from, to)` for every edge that meets the rows between two heights, some more than once.
template <class See>
void Outline::edges(float low, float high, const See& see) const {
  for (std::size_t row = row_of(low), last = row_of(high); row <= last; ++row)
    for (std::uint32_t k = first_[row]; k < first_[row + 1]; ++k)
      see(points_[members_[k]], points_[(members_[k] + 1) % points_.size()]);
}

int Outline::winding(float x, float y) const {
  if (!(x >= low_.x && x <= high_.x && y >= low_.y && y <= high_.y)) return 0;
  int turns = 0;
  edges(y, y, [&](const glm::vec2& from, const glm::vec2& to) {
    if ((from.y <= y) == (to.y <= y)) return;
    const float side = cross(to - from, glm::vec2(x, y) - from);
    if (from.y <= y && side > 0) ++turns;
    if (to.y <= y && side < 0) --turns;
  });
  return turns;
}

// Goes as far at once as the edge is away at least; only beside it are edges looked at.
bool Outline::holds(const glm::vec3& a, const glm::vec3& b) const {
  const float length = glm::distance(a, b);
  glm::vec3 at = a;
  for (float gone = 0;;) {
    // As far as the edge cannot be; near it a cell at a time, against the edges there.
    const float free = clearance(at), hop = std::max(free, cell_);
    const bool ends = gone + hop >= length;
    const glm::vec3 next = ends ? b : a + ((gone + hop) / length) * (b - a);
    if (free < cell_ && crosses(at, next)) return false;
    if (ends) return true;
    gone += hop;
    at = next;
  }
}

bool Outline::crosses(const glm::vec3& a, const glm::vec3& b) const {
  bool crossed = false;
  edges(std::min(a.y, b.y), std::max(a.y, b.y), [&](const glm::vec2& from, const glm::vec2& to) {
    crossed = crossed || meet({a.x, a.y}, {b.x, b.y}, from, to);
  });
  return crossed;
}

float Outline::distance_to_edge(const glm::vec3& p, std::uint32_t edge) const {
  const glm::vec2 from = points_[edge], way = points_[(edge + 1) % points_.size()] - from,
                  place = glm::vec2(p.x, p.y) - from;
  const float square = glm::dot(way, way);
  const float at = square > 0 ? glm::clamp(glm::dot(place, way) / square, 0.0f, 1.0f) : 0;
  return glm::distance(place, at * way);
}

float Outline::distance(const glm::vec3& p) const {
  float least = std::numeric_limits<float>::max();
  for (std::uint32_t i = 0; i < points_.size(); ++i) least = std::min(least, distance_to_edge(p, i));
  return least;
}

// Cells on the edge know an edge; the others take over what their neighbours know, in two sweeps. What they find is
// less than a cell farther than the nearest.
void Outline::measure() {
  const glm::vec3 size = high_ - low_;
  cell_ = std::max({size.x, size.y, std::numeric_limits<float>::min()}) / cells_along;
  across_ = static_cast<std::int32_t>(size.x / cell_) + 1;
  up_ = static_cast<std::int32_t>(size.y / cell_) + 1;
  constexpr std::uint32_t unknown = ~0u;
  nearest_.assign(static_cast<std::size_t>(across_ * up_), unknown);
  clearance_.assign(nearest_.size(), std::numeric_limits<float>::max());
  const auto offer = [&](std::int32_t x, std::int32_t y, std::uint32_t edge) {
    if (x < 0 || y < 0 || x >= across_ || y >= up_ || edge == unknown) return;
    const auto cell = static_cast<std::size_t>(y * across_ + x);
    if (nearest_[cell] == edge) return;
    const glm::vec3 middle = low_ + cell_ * glm::vec3(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 0);
    const float away = distance_to_edge(middle, edge);
    if (!(away < clearance_[cell])) return;
    clearance_[cell] = away;
    nearest_[cell] = edge;
  };
  for (std::uint32_t edge = 0; edge < points_.size(); ++edge) {
    const glm::vec2 from = points_[edge], way = points_[(edge + 1) % points_.size()] - from;
    const auto steps = static_cast<std::int32_t>(2 * glm::length(way) / cell_) + 1;
    for (std::int32_t k = 0; k <= steps; ++k) {
      const glm::vec2 at = (from + way * (static_cast<float>(k) / static_cast<float>(steps)) - glm::vec2(low_)) / cell_;
      offer(static_cast<std::int32_t>(at.x), static_cast<std::int32_t>(at.y), edge);
    }
  }
  const auto known = [&](std::int32_t x, std::int32_t y) {
    return x < 0 || y < 0 || x >= across_ || y >= up_ ? unknown : nearest_[static_cast<std::size_t>(y * across_ + x)];
  };
  for (std::int32_t sweep = 0; sweep < 2; ++sweep) {
    const std::int32_t back = sweep == 0 ? -1 : 1;
    for (std::int32_t row = 0; row < up_; ++row) {
      const std::int32_t y = sweep == 0 ? row : up_ - 1 - row;
      for (std::int32_t k = 0; k < across_; ++k) {
        const std::int32_t x = sweep == 0 ? k : across_ - 1 - k;
        offer(x, y, known(x + back, y));
        for (std::int32_t aside = -1; aside <= 1; ++aside) offer(x, y, known(x + aside, y + back));
      }
      for (std::int32_t k = 0; k < across_; ++k) {
        const std::int32_t x = sweep == 0 ? across_ - 1 - k : k;
        offer(x, y, known(x - back, y));
      }
    }
  }
  for (float& free : clearance_) free = std::max(0.0f, free - uncertain * cell_);
}

float Outline::about_distance(const glm::vec3& p) const {
  const glm::vec3 at = (p - low_) / cell_;
  const auto x = static_cast<std::int32_t>(std::clamp(at.x, 0.0f, static_cast<float>(across_ - 1)));
  const auto y = static_cast<std::int32_t>(std::clamp(at.y, 0.0f, static_cast<float>(up_ - 1)));
  return distance_to_edge(p, nearest_[static_cast<std::size_t>(y * across_ + x)]);
}

float Outline::clearance(const glm::vec3& p) const {
  const glm::vec3 at = (p - low_) / cell_;
  if (!(at.x >= 0 && at.y >= 0)) return 0;
  const auto x = static_cast<std::int32_t>(std::min(at.x, 1e6f)), y = static_cast<std::int32_t>(std::min(at.y, 1e6f));
  return x < across_ && y < up_ ? clearance_[static_cast<std::size_t>(y * across_ + x)] : 0;
}

float Outline::area() const {
  float twice = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) twice += cross(points_[i], points_[(i + 1) % points_.size()]);
  return 0.5f * std::fabs(twice);
}

}  // namespace panicle::particles
