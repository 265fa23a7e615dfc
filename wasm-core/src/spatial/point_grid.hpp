// A grid of points for neighbour queries: built anew for each set of points by counting sort, so that the same points
// are in the same order everywhere.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace panicle {

// A dense grid over the points' box. Points that are not finite, or beyond 1e30, are in no cell. All of one row of
// cells along x are contiguous, cells in ascending order, points of a cell by index: a *slot* is a place in that order.
// Code that visits many points a cell copies its data into slots, and reads runs of slots.
class PointGrid {
 public:
  PointGrid() = default;
  // `edge`: the cells' width, above 0; wider where more than about eight cells a point would come of it.
  PointGrid(std::span<const glm::vec3> points, float edge) { build(points, edge); }

  // Replaces all points; memory is reused.
  void build(std::span<const glm::vec3> points, float edge);

  // The index of the point in each slot.
  std::span<const std::uint32_t> ids() const { return ids_; }

  // Calls `see(index)` for every point in the 27 cells about `p`: all within an edge's length, and others.
  template <class See>
  void visit(const glm::vec3& p, const See& see) const {
    visit_runs(p, [&](std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t slot = first; slot < end; ++slot) see(ids_[slot]);
    });
  }

  // Calls `run(first, end)` for the slots of every row of these cells, in the same order.
  template <class Run>
  void visit_runs(const glm::vec3& p, const Run& run) const {
    const Cell at = cell_of(p);
    runs({at.x - 1, at.y - 1, at.z - 1}, {at.x + 1, at.y + 1, at.z + 1}, run);
  }

  // Calls `run(first, end)` for the slots of every row of cells that the box from `low` to `high` meets: of all points
  // in the box, and others.
  template <class Run>
  void within(const glm::vec3& low, const glm::vec3& high, const Run& run) const {
    runs(cell_of(low), cell_of(high), run);
  }

 private:
  struct Cell {
    std::int32_t x, y, z;
  };

  Cell cell_of(const glm::vec3& p) const;
  std::size_t row_of(std::int32_t y, std::int32_t z) const;

  template <class Run>
  void runs(const Cell& from, const Cell& to, const Run& run) const {
    const std::int32_t left = std::max(from.x, 0), right = std::min(to.x, count_.x - 1);
    if (left > right) return;
    for (std::int32_t z = std::max(from.z, 0); z <= std::min(to.z, count_.z - 1); ++z)
      for (std::int32_t y = std::max(from.y, 0); y <= std::min(to.y, count_.y - 1); ++y) {
        const std::uint32_t* row = &first_[row_of(y, z)];
        if (row[left] < row[right + 1]) run(row[left], row[right + 1]);
      }
  }

  glm::vec3 low_{0};
  float edge_ = 1;
  Cell count_{0, 0, 0};                      // 0 without points
  std::vector<std::uint32_t> first_, next_;  // of each cell's slots, and the end
  std::vector<std::uint32_t> ids_;
  std::vector<std::uint32_t> cells_;  // cells of the points, used while building
};

}  // namespace panicle
