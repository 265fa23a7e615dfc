#include "models/particles/waypoints.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace panicle::particles {
namespace {

constexpr float max_cells = 96;
// A goal may lie on the edge, from which nothing is visible: the test stops this share of the way before it.
constexpr float before_goal = 1e-3f;
constexpr std::int32_t around[8][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};

}  // namespace

// Begins shortest ways (Dijkstra) from the cells of a grid inside an outline to the nearest of some goals; `cell` is
// the least width of a cell. Cells are computed when first needed.
Waypoints::Waypoints(const Outline& outline, std::vector<glm::vec3> goals, float cell)
    : outline_(&outline), goals_(std::move(goals)) {
  const glm::vec3 size = outline.high() - outline.low();
  edge_ = std::max({cell, size.x / max_cells, size.y / max_cells, 1e-30f});
  across_ = static_cast<std::int32_t>(size.x / edge_) + 1;
  up_ = static_cast<std::int32_t>(size.y / edge_) + 1;
  cells_.resize(static_cast<std::size_t>(across_ * up_));
  begin();
}

// The middle of a cell.
glm::vec3 Waypoints::middle(std::int32_t x, std::int32_t y) const {
  return outline_->low() + edge_ * glm::vec3(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 0);
}

// Whether the way from `place`, the middle of a cell, over the corner `ahead` is shorter than the cell's known way.
// `ahead.way` is the length beyond the corner.
bool Waypoints::shorter(std::int32_t cell, const glm::vec3& place, const Cell& ahead) const {
  const float known = cells_[static_cast<std::size_t>(cell)].way;
  return known < 0 || glm::distance(place, ahead.corner) + ahead.way < known;
}

// Gives a cell the way over the corner `ahead` if that is shorter than its known one, and puts the cell into the queue.
void Waypoints::offer(std::int32_t cell, const glm::vec3& place, const Cell& ahead) {
  if (!shorter(cell, place, ahead)) return;
  const float way = glm::distance(place, ahead.corner) + ahead.way;
  cells_[static_cast<std::size_t>(cell)] = {ahead.corner, way, ahead.turns};
  open_.push({way, cell});
}

// Sets the way of the cells about each goal that see it; where none sees any goal, that of the cell nearest to the
// first goal.
void Waypoints::begin() {
  for (const glm::vec3& goal : goals_) {
    const glm::vec3 at = (goal - outline_->low()) / edge_;
    const auto column = static_cast<std::int32_t>(std::floor(at.x)), row = static_cast<std::int32_t>(std::floor(at.y));
    for (std::int32_t y = std::max(row - 1, 0); y <= std::min(row + 1, up_ - 1); ++y)
      for (std::int32_t x = std::max(column - 1, 0); x <= std::min(column + 1, across_ - 1); ++x)
        if (shorter(y * across_ + x, middle(x, y), {goal, 0}) && inside(x, y) && sees(middle(x, y), goal, false))
          offer(y * across_ + x, middle(x, y), {goal, 0});
  }
  if (!open_.empty()) return;
  std::int32_t best = -1;
  float nearest = 0;
  for (std::int32_t cell = 0; cell < across_ * up_; ++cell) {
    const float away = glm::distance(middle(cell % across_, cell / across_), goals_[0]);
    if (!inside(cell % across_, cell / across_) || (best >= 0 && away >= nearest)) continue;
    best = cell;
    nearest = away;
  }
  if (best >= 0) offer(best, middle(best % across_, best / across_), {goals_[0], 0});
}

// Whether a way leads from a cell: spreads from the nearest open cells until that is known.
bool Waypoints::reaches(std::int32_t cell) {
  const Cell& requested = cells_[static_cast<std::size_t>(cell)];
  if (requested.closed) return true;
  if (open_.empty() || !inside(cell % across_, cell / across_)) return false;
  while (!open_.empty() && !requested.closed) spread_next();
  return requested.closed;
}

// Offers the way of the nearest open cell to the cells around.
void Waypoints::spread_next() {
  const std::int32_t cell = open_.top().second;
  open_.pop();
  Cell& from = cells_[static_cast<std::size_t>(cell)];
  if (from.closed) return;
  from.closed = true;
  const std::int32_t x = cell % across_, y = cell / across_;
  const glm::vec3 place = middle(x, y);
  const Cell ahead{from.corner, from.way - glm::distance(place, from.corner), from.turns};
  for (const auto& [dx, dy] : around) {
    const std::int32_t to_x = x + dx, to_y = y + dy;
    if (to_x < 0 || to_y < 0 || to_x >= across_ || to_y >= up_) continue;
    const std::int32_t to = to_y * across_ + to_x;
    const glm::vec3 to_middle = middle(to_x, to_y);
    if (cells_[static_cast<std::size_t>(to)].closed || !shorter(to, to_middle, ahead) || !inside(to_x, to_y)) continue;
    if (sees(to_middle, ahead.corner, ahead.turns))
      offer(to, to_middle, ahead);
    else if (outline_->holds(to_middle, place))
      offer(to, to_middle, {place, from.way, true});
  }
}

// Whether the segment is inside the outline. `turns`: `to` is a corner where a way turns and not a goal, so that its
// end is tested as well.
bool Waypoints::sees(const glm::vec3& from, const glm::vec3& to, bool turns) const {
  return outline_->holds(from, turns ? to : to + before_goal * (from - to));
}

// Assigns to cells without a way the nearest cell that has one: outwards from those, ring by ring.
void Waypoints::fill() {
  while (!open_.empty()) spread_next();
  nearest_.assign(cells_.size(), -1);
  std::vector<std::int32_t> ring, next;
  for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(cells_.size()); ++cell)
    if (cells_[static_cast<std::size_t>(cell)].closed) {
      nearest_[static_cast<std::size_t>(cell)] = cell;
      ring.push_back(cell);
    }
  for (; !ring.empty(); std::swap(ring, next)) {
    next.clear();
    for (const std::int32_t cell : ring) {
      const std::int32_t x = cell % across_, y = cell / across_;
      for (const auto& [dx, dy] : around) {
        if (x + dx < 0 || y + dy < 0 || x + dx >= across_ || y + dy >= up_) continue;
        std::int32_t& nearest = nearest_[static_cast<std::size_t>((y + dy) * across_ + x + dx)];
        if (nearest >= 0) continue;
        nearest = nearest_[static_cast<std::size_t>(cell)];
        next.push_back((y + dy) * across_ + x + dx);
      }
    }
  }
}

// Chooses where a particle at `p` walks next on its shortest way to a goal: the corner that its cell or a neighbour
// leads to, else the nearest cell with a way.
Waypoints::Choice Waypoints::choose(const glm::vec3& p) {
  const glm::vec3 from_low = (p - outline_->low()) / edge_;
  const auto within = [](float at, std::int32_t count) {
    return static_cast<std::int32_t>(std::clamp(at, 0.0f, static_cast<float>(count - 1)));
  };
  const std::int32_t x = within(from_low.x, across_), y = within(from_low.y, up_);
  // The cell's own corner if it is visible; else that of a cell around it.
  Choice best{p, -1};
  const auto consider = [&](std::int32_t cell_x, std::int32_t cell_y) {
    if (cell_x < 0 || cell_y < 0 || cell_x >= across_ || cell_y >= up_) return;
    const std::int32_t number = cell_y * across_ + cell_x;
    if (!reaches(number)) return;
    const Cell& cell = cells_[static_cast<std::size_t>(number)];
    const float beyond = cell.way - glm::distance(middle(cell_x, cell_y), cell.corner);
    const float way = glm::distance(p, cell.corner) + beyond;
    if ((best.way < 0 || way < best.way) && sees(p, cell.corner, cell.turns)) best = {cell.corner, way};
  };
  consider(x, y);
  if (best.way >= 0) return best;
  for (const auto& [dx, dy] : around) consider(x + dx, y + dy);
  if (best.way >= 0) return best;
  if (nearest_.empty()) fill();
  const std::int32_t at_target = nearest_[static_cast<std::size_t>(y * across_ + x)];
  if (at_target < 0) return {goals_[0], glm::distance(p, goals_[0])};
  const glm::vec3 place = middle(at_target % across_, at_target / across_);
  return {place, glm::distance(p, place) + cells_[static_cast<std::size_t>(at_target)].way};
}

// The next corner on the way from p to the nearest goal, and the length of that way.
glm::vec3 Waypoints::next(const glm::vec3& p) { return choose(p).corner; }

// The length of the shortest known way from a point to a goal.
float Waypoints::way(const glm::vec3& p) { return choose(p).way; }

}  // namespace panicle::particles
