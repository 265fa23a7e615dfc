#include "models/particles/outline.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace panicle::particles {
namespace {

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

bool Outline::holds(const glm::vec3& a, const glm::vec3& b) const {
  bool free = true;
  edges(std::min(a.y, b.y), std::max(a.y, b.y), [&](const glm::vec2& from, const glm::vec2& to) {
    free = free && !meet({a.x, a.y}, {b.x, b.y}, from, to);
  });
  return free;
}

float Outline::distance(const glm::vec3& p) const {
  float least = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const glm::vec2 from = points_[i], way = points_[(i + 1) % points_.size()] - from, place = glm::vec2(p.x, p.y) - from;
    const float square = glm::dot(way, way);
    const float at = square > 0 ? glm::clamp(glm::dot(place, way) / square, 0.0f, 1.0f) : 0;
    least = std::min(least, glm::distance(place, at * way));
  }
  return least;
}

float Outline::area() const {
  float twice = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) twice += cross(points_[i], points_[(i + 1) % points_.size()]);
  return 0.5f * std::fabs(twice);
}

}  // namespace panicle::particles
