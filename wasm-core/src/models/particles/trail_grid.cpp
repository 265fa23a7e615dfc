#include "models/particles/trail_grid.hpp"

#include <algorithm>

namespace panicle::particles {

// Builds an empty grid over the box from `low` to `high`, with cells at least `reach` wide, wider if there were more
// than `max_cells`.
TrailGrid::TrailGrid(const glm::vec3& low, const glm::vec3& high, float reach, std::uint32_t max_cells)
    : low_(low), reach_(reach), edge_(reach) {
  const glm::vec3 size = high - low;
  const auto cells = [&] { return (size.x / edge_ + 1) * (size.y / edge_ + 1) * (size.z / edge_ + 1); };
  while (cells() > static_cast<float>(max_cells)) edge_ *= 1.25f;
  const auto along = [this](float length) { return static_cast<std::int32_t>(length / edge_) + 1; };
  count_ = {along(size.x), along(size.y), along(size.z)};
  last_.assign(index({0, 0, count_.z}), -1);
}

// The cell that a point is in, clamped to the grid.
TrailGrid::Cell TrailGrid::cell_of(const glm::vec3& p) const {
  const auto along = [this](float from_low, std::int32_t count) {
    return static_cast<std::int32_t>(std::clamp(from_low / edge_, 0.0f, static_cast<float>(count - 1)));
  };
  return {along(p.x - low_.x, count_.x), along(p.y - low_.y, count_.y), along(p.z - low_.z, count_.z)};
}

// Adds the next place; the places of a cell form a linked list, the last one first.
void TrailGrid::add(const glm::vec3& place) {
  std::int32_t& last = last_[index(cell_of(place))];
  before_.push_back(last);
  last = static_cast<std::int32_t>(before_.size()) - 1;
}

}  // namespace panicle::particles
