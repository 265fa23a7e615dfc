#include "spatial/point_grid.hpp"

#include <cmath>

namespace panicle {
namespace {

constexpr float farthest = 1e30f;  // no difference of coordinates overflows

// Whether a point has finite coordinates that are not too large for differences.
bool is_placeable(const glm::vec3& p) {
  return std::fabs(p.x) <= farthest && std::fabs(p.y) <= farthest && std::fabs(p.z) <= farthest;
}

}  // namespace

// The index of the first cell of a row of cells along x.
std::size_t PointGrid::row_of(std::int32_t y, std::int32_t z) const {
  return static_cast<std::size_t>(z * count_.y + y) * static_cast<std::size_t>(count_.x);
}

// Returns the cell of a point. Points outside are in a cell beyond the outermost, NaN before the first.
PointGrid::Cell PointGrid::cell_of(const glm::vec3& p) const {
  const auto along = [this](float from_low, std::int32_t count) {
    const float at = from_low / edge_;
    if (!(at > -2)) return -2;
    if (!(at < static_cast<float>(count) + 2)) return count + 2;
    const auto whole = static_cast<std::int32_t>(at);
    return static_cast<float>(whole) > at ? whole - 1 : whole;
  };
  return {along(p.x - low_.x, count_.x), along(p.y - low_.y, count_.y), along(p.z - low_.z, count_.z)};
}

// Sorts points into cells of width `edge` or wider, by counting. Points that are not finite are in no cell.
void PointGrid::build(std::span<const glm::vec3> points, float edge) {
  glm::vec3 high(-farthest);
  low_ = glm::vec3(farthest);
  std::uint32_t placed = 0;
  for (const glm::vec3& p : points) {
    if (!is_placeable(p)) continue;
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    ++placed;
  }
  ids_.resize(placed);
  count_ = {0, 0, 0};
  if (placed == 0) return;
  // Few points far apart need no finer cells than there are points.
  const float max_cells = 8.0f * static_cast<float>(placed) + 64;
  const glm::vec3 size = high - low_;
  edge_ = edge > 0 ? edge : 1;
  const auto cells = [&] { return (size.x / edge_ + 1) * (size.y / edge_ + 1) * (size.z / edge_ + 1); };
  while (cells() > max_cells) edge_ *= 1.5f;
  const auto cells_along = [this](float length) { return static_cast<std::int32_t>(length / edge_) + 1; };
  count_ = {cells_along(size.x), cells_along(size.y), cells_along(size.z)};

  const auto index_of = [this](const glm::vec3& p) {
    const Cell cell = cell_of(p);
    return row_of(cell.y, cell.z) + static_cast<std::size_t>(cell.x);
  };
  first_.assign(row_of(0, count_.z) + 1, 0);
  cells_.clear();
  for (const glm::vec3& p : points) {
    if (!is_placeable(p)) continue;
    cells_.push_back(static_cast<std::uint32_t>(index_of(p)));
    ++first_[cells_.back() + 1];
  }
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  next_.assign(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0, k = 0; i < points.size(); ++i)
    if (is_placeable(points[i])) ids_[next_[cells_[k++]]++] = i;
}

}  // namespace panicle
