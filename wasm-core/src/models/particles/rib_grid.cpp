#include "models/particles/rib_grid.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace panicle::particles {
namespace {

constexpr std::int32_t wide = 8, within = 5;  // cells of the first division along an edge, and cells of each of those
constexpr std::int32_t along = wide * within;
constexpr float rounding = 1e-5f;

}  // namespace

RibGrid::RibGrid(const Ribs& ribs, const glm::vec3& low, const glm::vec3& high)
    : ribs_(&ribs), low_(low), cell_((high - low) / static_cast<float>(along)) {
  cell_.x = std::max(cell_.x, std::numeric_limits<float>::min());
  cell_.y = std::max(cell_.y, std::numeric_limits<float>::min());
  for (std::uint32_t i = 1; i < ribs.places.size(); ++i) every_.push_back(i);
  std::vector<std::uint8_t> continued(ribs.places.size(), 0);
  line_.push_back(0);
  lines_.emplace_back();
  for (const std::uint32_t i : every_) {
    const auto next = static_cast<std::size_t>(ribs.next[i]);
    if (continued[next]) lines_.emplace_back();
    line_.push_back(continued[next] ? static_cast<std::uint32_t>(lines_.size()) - 1 : line_[next]);
    lines_[line_.back()].push_back(i);
    continued[next] = 1;
  }
  wide_.resize(static_cast<std::size_t>(wide * wide));
  fine_.resize(static_cast<std::size_t>(along * along));
}

// Of `from`, those that come as near to some place about the middle as the nearest does.
void RibGrid::select(const Pieces& from, const glm::vec2& middle, float radius, Pieces& selected) const {
  const glm::vec3 place = low_ + cell_ * glm::vec3(middle, 0);
  std::vector<float> distances;
  float least = std::numeric_limits<float>::max();
  for (const std::uint32_t i : from) {
    distances.push_back(ribs_->foot_on(i, place).distance);
    least = std::min(least, distances.back());
  }
  const float reach = (least + 2 * radius) * (1 + rounding) + rounding;
  for (std::size_t k = 0; k < from.size(); ++k)
    if (distances[k] <= reach) selected.push_back(from[k]);
}

const RibGrid::Pieces& RibGrid::pieces_about(std::int32_t x, std::int32_t y) const {
  Pieces& fine = fine_[static_cast<std::size_t>(y * along + x)];
  if (!fine.empty() || every_.empty()) return fine;
  const std::int32_t column = x / within, row = y / within;
  const float radius = 0.5f * glm::length(cell_), half = 0.5f * static_cast<float>(within);
  Pieces& about = wide_[static_cast<std::size_t>(row * wide + column)];
  if (about.empty()) {
    const glm::vec2 middle(static_cast<float>(column * within) + half, static_cast<float>(row * within) + half);
    select(every_, middle, radius * static_cast<float>(within), about);
  }
  select(about, {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, radius, fine);
  return fine;
}

Ribs::Foot RibGrid::nearest(const glm::vec3& p) const {
  const float x = (p.x - low_.x) / cell_.x, y = (p.y - low_.y) / cell_.y;
  if (!(x >= 0 && y >= 0 && x < static_cast<float>(along) && y < static_cast<float>(along))) return ribs_->nearest(p);
  Ribs::Foot best = ribs_->at_base(p);
  for (const std::uint32_t i : pieces_about(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)))
    if (const Ribs::Foot foot = ribs_->foot_on(i, p); foot.distance < best.distance) best = foot;
  return best;
}

Ribs::Foot RibGrid::nearest_on(std::uint32_t line, const glm::vec3& p) const {
  Ribs::Foot best{0, 0, p, std::numeric_limits<float>::max()};
  for (const std::uint32_t i : lines_[line])
    if (const Ribs::Foot foot = ribs_->foot_on(i, p); foot.distance < best.distance) best = foot;
  return best;
}

}  // namespace panicle::particles
