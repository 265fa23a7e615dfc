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
  std::vector<std::uint32_t> every, coarse, fine;
  for (std::uint32_t i = 1; i < ribs.places.size(); ++i) every.push_back(i);
  std::vector<std::uint8_t> continued(ribs.places.size(), 0);
  line_.push_back(0);
  lines_.emplace_back();
  for (const std::uint32_t i : every) {
    const auto next = static_cast<std::size_t>(ribs.next[i]);
    if (continued[next]) lines_.emplace_back();
    line_.push_back(continued[next] ? static_cast<std::uint32_t>(lines_.size()) - 1 : line_[next]);
    lines_[line_.back()].push_back(i);
    continued[next] = 1;
  }
  std::vector<float> distances;
  // Of `from`, those that come as near to some place about the middle as the nearest does.
  const auto select = [&](const std::vector<std::uint32_t>& from, const glm::vec3& middle, float radius,
                          std::vector<std::uint32_t>& selected) {
    distances.clear();
    float least = std::numeric_limits<float>::max();
    for (const std::uint32_t i : from) {
      distances.push_back(ribs.foot_on(i, middle).distance);
      least = std::min(least, distances.back());
    }
    selected.clear();
    for (std::size_t k = 0; k < from.size(); ++k)
      if (distances[k] <= (least + 2 * radius) * (1 + rounding) + rounding) selected.push_back(from[k]);
  };
  std::vector<std::vector<std::uint32_t>> by_cell(static_cast<std::size_t>(along * along));
  const float radius = 0.5f * glm::length(cell_);
  const auto middle = [&](float x, float y) { return low_ + glm::vec3(cell_.x * x, cell_.y * y, 0); };
  for (std::int32_t row = 0; row < wide; ++row)
    for (std::int32_t column = 0; column < wide; ++column) {
      const auto half = 0.5f * static_cast<float>(within);
      select(every, middle(static_cast<float>(column * within) + half, static_cast<float>(row * within) + half),
             radius * static_cast<float>(within), coarse);
      for (std::int32_t y = row * within; y < (row + 1) * within; ++y)
        for (std::int32_t x = column * within; x < (column + 1) * within; ++x) {
          select(coarse, middle(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f), radius, fine);
          by_cell[static_cast<std::size_t>(y * along + x)] = fine;
        }
    }
  first_.push_back(0);
  for (const std::vector<std::uint32_t>& pieces : by_cell) {
    pieces_.insert(pieces_.end(), pieces.begin(), pieces.end());
    first_.push_back(static_cast<std::uint32_t>(pieces_.size()));
  }
}

Ribs::Foot RibGrid::nearest(const glm::vec3& p) const {
  const float x = (p.x - low_.x) / cell_.x, y = (p.y - low_.y) / cell_.y;
  if (!(x >= 0 && y >= 0 && x < static_cast<float>(along) && y < static_cast<float>(along))) return ribs_->nearest(p);
  const auto cell = static_cast<std::size_t>(static_cast<std::int32_t>(y) * along + static_cast<std::int32_t>(x));
  Ribs::Foot best = ribs_->at_base(p);
  for (std::uint32_t k = first_[cell]; k < first_[cell + 1]; ++k)
    if (const Ribs::Foot foot = ribs_->foot_on(pieces_[k], p); foot.distance < best.distance) best = foot;
  return best;
}

Ribs::Foot RibGrid::nearest_on(std::uint32_t line, const glm::vec3& p) const {
  Ribs::Foot best{0, 0, p, std::numeric_limits<float>::max()};
  for (const std::uint32_t i : lines_[line])
    if (const Ribs::Foot foot = ribs_->foot_on(i, p); foot.distance < best.distance) best = foot;
  return best;
}

}  // namespace panicle::particles
