// Shortest ways inside an outline: from anywhere inside to the nearest of some goals, by corners, never across the
// edge.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <queue>
#include <utility>
#include <vector>

#include "models/particles/outline.hpp"

namespace panicle::particles {

// A field of waypoints on a grid: Theta* (Daniel et al. 2010, "Theta*: any-angle path planning on grids"), run from the
// goals through the cells that lie inside, only as far as queries need.
class Waypoints {
 public:
  // `outline` must outlive it. `cell`: the grid's width; wider where more than 96 would lie along an edge of the box.
  Waypoints(const Outline& outline, std::vector<glm::vec3> goals, float cell);

  // The point visible from `p` on the shortest way known to a goal: the goal, or a corner to turn at. Outside, the
  // nearest cell inside.
  glm::vec3 next(const glm::vec3& p);
  // The length of that way.
  float way(const glm::vec3& p);

 private:
  struct Cell {
    glm::vec3 corner{0};  // where to go from its middle
    float way = -1;       // from there; below 0 where no way is known
    bool turns = false;   // not a goal
    bool closed = false;  // no shorter way will be found
  };
  struct Choice {
    glm::vec3 corner;
    float way;
  };

  glm::vec3 middle(std::int32_t x, std::int32_t y) const;
  bool sees(const glm::vec3& from, const glm::vec3& to, bool turns) const;
  // Whether a cell's middle is inside the outline.
  bool inside(std::int32_t x, std::int32_t y) const { return outline_->contains(middle(x, y)); }
  bool shorter(std::int32_t cell, const glm::vec3& place, const Cell& ahead) const;
  void offer(std::int32_t cell, const glm::vec3& place, const Cell& ahead);
  void begin();
  bool reaches(std::int32_t cell);
  void spread_next();
  void fill();
  Choice choose(const glm::vec3& p);

  const Outline* outline_;
  std::vector<glm::vec3> goals_;
  float edge_;
  std::int32_t across_ = 1, up_ = 1;
  std::vector<Cell> cells_;
  using Entry = std::pair<float, std::int32_t>;  // a way's length and its cell
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  std::vector<std::int32_t> nearest_;  // of each cell: itself, or the nearest that has a way; made at the first query
};

}  // namespace panicle::particles
