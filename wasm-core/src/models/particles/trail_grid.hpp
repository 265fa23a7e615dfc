// Places that trails have passed, for particles that end in a trail: added one by one, looked up at every step.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace panicle::particles {

// A dense grid over a box; places outside are in the cell nearest to them.
class TrailGrid {
 public:
  TrailGrid() = default;
  // `reach`: radius of a search; cells are wider where there would be more than `max_cells`.
  TrailGrid(const glm::vec3& low, const glm::vec3& high, float reach, std::uint32_t max_cells);

  void add(const glm::vec3& place);  // the next place; they are numbered from 0
  std::size_t size() const { return before_.size(); }

  // Calls `see(number)` for every place in the cells about `p`: all within `reach`, and others.
  template <class See>
  void visit(const glm::vec3& p, const See& see) const {
    const Cell from = cell_of(p - glm::vec3(reach_)), to = cell_of(p + glm::vec3(reach_));
    for (std::int32_t z = from.z; z <= to.z; ++z)
      for (std::int32_t y = from.y; y <= to.y; ++y)
        for (std::int32_t x = from.x; x <= to.x; ++x)
          for (std::int32_t at = last_[index({x, y, z})]; at >= 0; at = before_[static_cast<std::size_t>(at)]) see(at);
  }

 private:
  struct Cell {
    std::int32_t x, y, z;
  };
  Cell cell_of(const glm::vec3& p) const;
  // The index of a cell in the list of all, x fastest.
  std::size_t index(const Cell& cell) const {
    return static_cast<std::size_t>((cell.z * count_.y + cell.y) * count_.x + cell.x);
  }

  glm::vec3 low_{0};
  float reach_ = 0, edge_ = 1;
  Cell count_{0, 0, 0};
  std::vector<std::int32_t> last_;    // of each cell: the place added last; −1 where there is none
  std::vector<std::int32_t> before_;  // of each place: the one added before it in its cell
};

}  // namespace panicle::particles
