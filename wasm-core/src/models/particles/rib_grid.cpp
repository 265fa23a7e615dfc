#include "models/particles/rib_grid.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace panicle::particles {
namespace {

constexpr std::int32_t widest = 5,
                       divisions = 3;  // cells of the first grid along an edge, and the number of its halvings
constexpr std::int32_t along = widest << divisions;
constexpr float rounding = 1e-5f;

}  // namespace

// Numbers the lines of ribs (unbranched runs, also across forks) and prepares empty grids over the box from `low` to
// `high`, each with cells half as wide as the one before.
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
  for (std::int32_t level = 0; level <= divisions; ++level)
    grids_.emplace_back(static_cast<std::size_t>((widest << level) * (widest << level)));
}

// Selects the pieces of `from` that can be nearest to some point within `radius` of the middle: those no farther than
// the nearest one by twice the radius.
RibGrid::Pieces RibGrid::selected(const Pieces& from, const glm::vec3& middle, float radius) const {
  std::vector<float> distances;
  distances.reserve(from.size());
  float least = std::numeric_limits<float>::max();
  for (const std::uint32_t i : from) {
    distances.push_back(std::sqrt(ribs_->square_to(i, middle)));
    least = std::min(least, distances.back());
  }
  const float reach = (least + 2 * radius) * (1 + rounding) + rounding;
  Pieces near;
  for (std::size_t k = 0; k < from.size(); ++k)
    if (distances[k] <= reach) near.push_back(from[k]);
  return near;
}

// The pieces that can be nearest to a point of a cell; selected from those of the coarser cell around it when first
// needed.
const RibGrid::Pieces& RibGrid::pieces_about(std::int32_t x, std::int32_t y, std::int32_t level) const {
  Pieces& pieces = grids_[static_cast<std::size_t>(level)][static_cast<std::size_t>(y * (widest << level) + x)];
  if (!pieces.empty() || every_.empty()) return pieces;
  const glm::vec3 cell = static_cast<float>(1 << (divisions - level)) * cell_;
  const glm::vec3 middle = low_ + cell * glm::vec3(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 0);
  pieces = selected(level > 0 ? pieces_about(x / 2, y / 2, level - 1) : every_, middle, 0.5f * glm::length(cell));
  return pieces;
}

// The point of the ribs that is nearest to p.
Ribs::Foot RibGrid::nearest(const glm::vec3& p) const {
  const float x = (p.x - low_.x) / cell_.x, y = (p.y - low_.y) / cell_.y;
  if (!(x >= 0 && y >= 0 && x < static_cast<float>(along) && y < static_cast<float>(along))) return ribs_->nearest(p);
  return ribs_->nearest(p, pieces_about(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), divisions));
}

// The point of one line of ribs that is nearest to p.
Ribs::Foot RibGrid::nearest_on(std::uint32_t line, const glm::vec3& p) const {
  Ribs::Foot best{0, 0, p, std::numeric_limits<float>::max()};
  for (const std::uint32_t i : lines_[line])
    if (const Ribs::Foot foot = ribs_->foot_on(i, p); foot.distance < best.distance) best = foot;
  return best;
}

}  // namespace panicle::particles
