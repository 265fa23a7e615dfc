// Ways through an outline that bends: from anywhere inside to the nearest of some goals, by corners, never across the
// edge.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/particles/outline.hpp"

namespace panicle::particles {

// A field of waypoints on a grid: Theta* (Daniel et al. 2010, "Theta*: any-angle path planning on grids"), run from the
// goals to every cell that lies inside.
class Waypoints {
 public:
  // `outline` must outlive it. `cell`: the grid's width; wider where more than 128 would lie along an edge of the box.
  Waypoints(const Outline& outline, std::vector<glm::vec3> goals, float cell);

  // What is seen from `p` on the shortest way known to a goal: the goal, or a corner to turn at. Outside, the nearest
  // cell inside.
  glm::vec3 next(const glm::vec3& p) const;
  // The length of that way.
  float way(const glm::vec3& p) const;

 private:
  struct Cell {
    glm::vec3 corner{0};  // where to go from its middle
    float way = -1;       // from there; below 0 where no way is known
    bool turns = false;   // not a goal
    bool reached() const { return way >= 0; }
  };
  struct Choice {
    glm::vec3 corner;
    float way;
  };

  glm::vec3 middle(std::int32_t x, std::int32_t y) const;
  bool sees(const glm::vec3& from, const glm::vec3& to, bool turns) const;
  const Cell& at(std::int32_t x, std::int32_t y) const { return cells_[static_cast<std::size_t>(y * across_ + x)]; }
  void spread();
  void fill();
  Choice choose(const glm::vec3& p) const;

  const Outline* outline_;
  std::vector<glm::vec3> goals_;
  float edge_;
  std::int32_t across_ = 1, up_ = 1;
  std::vector<Cell> cells_;
  std::vector<std::int32_t> nearest_;  // of each cell: itself, or the nearest that has a way
};

}  // namespace panicle::particles
