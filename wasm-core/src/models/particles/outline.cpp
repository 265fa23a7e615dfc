#include "models/particles/outline.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace panicle::particles {
namespace {

constexpr float cells_along = 64;
// In cells: distance from a cell's middle to its corner; the error of the nearest edge found by the sweeps; and the
// distance of an edge below which all others as near are tested.
constexpr float to_corner = 0.75f, too_far = 1;
constexpr std::int32_t near = 3;
constexpr float cells_beside = 4;  // length of a way that is tested at once near the edge
constexpr float rounding = 1e-3f;  // of a cell: an edge this near to a cell is listed in it

// The third component of the cross product: twice the signed area of the triangle.
float cross(const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; }

// Whether the segments ab and cd cross or touch: their boxes overlap, and neither has both ends strictly on one side of
// the other.
bool segments_meet(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c, const glm::vec2& d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x)) return false;
  if (std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) return false;
  const float c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const float a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  return !((c_side > 0 && d_side > 0) || (c_side < 0 && d_side < 0) || (a_side > 0 && b_side > 0) ||
           (a_side < 0 && b_side < 0));
}

}  // namespace

// Closes the polygon, sorts its edges into rows for fast queries, and measures it.
Outline::Outline(std::vector<glm::vec2> points) : points_(std::move(points)) {
  if (points_.empty()) points_.push_back({0, 0});
  points_.push_back(points_[0]);
  glm::vec2 low = points_[0], high = low;
  for (const glm::vec2& p : points_) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  low_ = {low.x, low.y, 0};
  high_ = {high.x, high.y, 0};
  const std::size_t rows = count();
  row_height_ = std::max((high.y - low.y) / static_cast<float>(rows), std::numeric_limits<float>::min());
  const auto reach = [this](std::size_t i) {
    const float from = points_[i].y, to = points_[i + 1].y;
    return std::pair(row_of(std::min(from, to)), row_of(std::max(from, to)));
  };
  first_.assign(rows + 1, 0);
  for (std::size_t i = 0; i < count(); ++i)
    for (auto [row, last] = reach(i); row <= last; ++row) ++first_[row + 1];
  for (std::size_t row = 0; row < rows; ++row) first_[row + 1] += first_[row];
  members_.resize(first_[rows]);
  std::vector<std::uint32_t> free(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < count(); ++i)
    for (auto [row, last] = reach(i); row <= last; ++row) members_[free[row]++] = i;
  measure();
  list_edges();
  make_certain();
  find_sides();
}

// The row, for winding numbers, that the height y is in.
std::size_t Outline::row_of(float y) const {
  const float at = (y - low_.y) / row_height_;
  return static_cast<std::size_t>(std::clamp(at, 0.0f, static_cast<float>(count() - 1)));
}

// The winding number of the polygon about a place: edges that cross the line from it towards +x, upwards less
// downwards. 0 outside the box.
int Outline::winding(float x, float y) const {
  if (!(x >= low_.x && x <= high_.x && y >= low_.y && y <= high_.y)) return 0;
  int turns = 0;
  const std::size_t row = row_of(y);
  for (std::uint32_t k = first_[row]; k < first_[row + 1]; ++k) {
    const glm::vec2 from = points_[members_[k]], to = points_[members_[k] + 1];
    if ((from.y <= y) == (to.y <= y)) continue;
    const float side = cross(to - from, glm::vec2(x, y) - from);
    if (from.y <= y && side > 0) ++turns;
    if (to.y <= y && side < 0) --turns;
  }
  return turns;
}

// Whether a place is inside. NaN is outside.
bool Outline::contains(const glm::vec3& p) const {
  if (!(p.x >= low_.x && p.x <= high_.x && p.y >= low_.y && p.y <= high_.y)) return false;
  // Where no edge comes near, all of a cell is on one side. (For a place on the border of two cells either cell will
  // do: the certain distance reaches that far.)
  const auto along = [this](float from_low, std::int32_t cells) {
    return std::min(static_cast<std::int32_t>(from_low * per_cell_), cells - 1);
  };
  const auto cell = static_cast<std::size_t>(along(p.y - low_.y, up_) * across_ + along(p.x - low_.x, across_));
  return clearance_[cell] > 0 ? inside_[cell] != 0 : winding(p.x, p.y) != 0;
}

// Calls `visit(cell)` for every cell that the segment from a to b meets, and for some cells beside it.
template <class See>
void Outline::cells_between(const glm::vec2& a, const glm::vec2& b, const See& visit) const {
  const glm::vec2 from = a.y <= b.y ? a : b, to = a.y <= b.y ? b : a;
  const float slack = rounding * cell_, rise = to.y - from.y;
  const std::int32_t top = line_of(to.y + slack);
  for (std::int32_t y = line_of(from.y - slack); y <= top; ++y) {
    // The part of the edge in this row.
    const float begin = low_.y + static_cast<float>(y) * cell_ - slack, end = begin + cell_ + 2 * slack;
    const float enters = rise > 0 ? glm::clamp((begin - from.y) / rise, 0.0f, 1.0f) : 0,
                leaves = rise > 0 ? glm::clamp((end - from.y) / rise, 0.0f, 1.0f) : 1;
    const float one = from.x + enters * (to.x - from.x), other = from.x + leaves * (to.x - from.x);
    const std::int32_t right = column_of(std::max(one, other) + slack);
    for (std::int32_t x = column_of(std::min(one, other) - slack); x <= right; ++x)
      visit(static_cast<std::size_t>(y * across_ + x));
  }
}

// Lists the edges that meet each cell: counts those of each, then fills in their numbers, in ascending order.
void Outline::list_edges() {
  first_in_.assign(nearest_.size() + 1, 0);
  for (std::uint32_t edge = 0; edge < count(); ++edge)
    cells_between(points_[edge], points_[edge + 1], [&](std::size_t cell) { ++first_in_[cell + 1]; });
  for (std::size_t cell = 0; cell < nearest_.size(); ++cell) first_in_[cell + 1] += first_in_[cell];
  edges_in_.resize(first_in_.back());
  std::vector<std::uint32_t> free(first_in_.begin(), first_in_.end() - 1);
  for (std::uint32_t edge = 0; edge < count(); ++edge)
    cells_between(points_[edge], points_[edge + 1], [&](std::size_t cell) { edges_in_[free[cell]++] = edge; });
}

// Determines whether each cell is inside, for cells that no edge comes near.
void Outline::find_sides() {
  inside_.assign(nearest_.size(), 0);
  for (std::int32_t y = 0; y < up_; ++y)
    for (std::int32_t x = 0; x < across_; ++x) {
      const auto cell = static_cast<std::size_t>(y * across_ + x);
      if (!(clearance_[cell] > 0)) continue;
      const glm::vec3 middle = low_ + cell_ * glm::vec3(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 0);
      inside_[cell] = winding(middle.x, middle.y) != 0;
    }
}

// Whether the segment from a to b stays inside. Walks along it in hops as long as the clearance, and tests edges only
// where that is less than a cell.
bool Outline::holds(const glm::vec3& a, const glm::vec3& b) const {
  const float length = glm::distance(a, b), beside = cells_beside * cell_;
  glm::vec3 at = a;
  for (float gone = 0;;) {
    // By the certain distance; near the edge some cells at a time, tested against the edges there.
    const float free = clearance(at), hop = free < cell_ ? beside : free;
    const bool ends = gone + hop >= length;
    const glm::vec3 next = ends ? b : a + ((gone + hop) / length) * (b - a);
    if (free < cell_ && crosses({at.x, at.y}, {next.x, next.y})) return false;
    if (ends) return true;
    gone += hop;
    at = next;
  }
}

// Whether the segment from a to b crosses or touches an edge.
bool Outline::crosses(const glm::vec2& a, const glm::vec2& b) const {
  bool crossed = false;
  cells_between(a, b, [&](std::size_t cell) {
    for (std::uint32_t k = first_in_[cell]; k < first_in_[cell + 1] && !crossed; ++k)
      crossed = segments_meet(a, b, points_[edges_in_[k]], points_[edges_in_[k] + 1]);
  });
  return crossed;
}

// The column and the line of cells that a coordinate is in, clamped to the grid.
std::int32_t Outline::column_of(float x) const {
  return static_cast<std::int32_t>(std::clamp((x - low_.x) / cell_, 0.0f, static_cast<float>(across_ - 1)));
}

// The row of cells at a height.
std::int32_t Outline::line_of(float y) const {
  return static_cast<std::int32_t>(std::clamp((y - low_.y) / cell_, 0.0f, static_cast<float>(up_ - 1)));
}

// The distance of a point from the edge of that number.
float Outline::distance_to_edge(const glm::vec3& p, std::uint32_t edge) const {
  const glm::vec2 from = points_[edge], way = points_[edge + 1] - from, place = glm::vec2(p.x, p.y) - from;
  const float square = glm::dot(way, way);
  const float at = square > 0 ? glm::clamp(glm::dot(place, way) / square, 0.0f, 1.0f) : 0;
  return glm::distance(place, at * way);
}

// The exact distance of a point from the nearest edge.
float Outline::distance(const glm::vec3& p) const {
  float least = std::numeric_limits<float>::max();
  for (std::uint32_t i = 0; i < count(); ++i) least = std::min(least, distance_to_edge(p, i));
  return least;
}

// Whether a point is at least `reach` away from all edges.
bool Outline::keeps_off(const glm::vec3& p, float reach) const {
  if (clearance(p) >= reach) return true;
  const std::int32_t left = column_of(p.x - reach), right = column_of(p.x + reach), top = line_of(p.y + reach);
  for (std::int32_t y = line_of(p.y - reach); y <= top; ++y)
    for (std::uint32_t k = first_in_[static_cast<std::size_t>(y * across_ + left)],
                       end = first_in_[static_cast<std::size_t>(y * across_ + right) + 1];
         k < end; ++k)
      if (distance_to_edge(p, edges_in_[k]) < reach) return false;
  return true;
}

// Builds a grid over the box and finds for each cell an edge near its middle and its distance, as a distance transform:
// cells on an edge begin with it, the others take over their neighbours' edges in two sweeps. The edge found is less
// than a cell farther than the nearest.
void Outline::measure() {
  const glm::vec3 size = high_ - low_;
  cell_ = std::max({size.x, size.y, std::numeric_limits<float>::min()}) / cells_along;
  per_cell_ = 1 / std::max(cell_, std::numeric_limits<float>::min());
  across_ = static_cast<std::int32_t>(size.x / cell_) + 1;
  up_ = static_cast<std::int32_t>(size.y / cell_) + 1;
  constexpr std::uint32_t unknown = ~0u;
  nearest_.assign(static_cast<std::size_t>(across_ * up_), unknown);
  clearance_.assign(nearest_.size(), std::numeric_limits<float>::max());
  const auto offer = [&](std::int32_t x, std::int32_t y, std::uint32_t edge) {
    if (x < 0 || y < 0 || x >= across_ || y >= up_ || edge == unknown) return;
    const auto cell = static_cast<std::size_t>(y * across_ + x);
    if (nearest_[cell] == edge) return;
    const glm::vec3 middle = low_ + cell_ * glm::vec3(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 0);
    const float away = distance_to_edge(middle, edge);
    if (!(away < clearance_[cell])) return;
    clearance_[cell] = away;
    nearest_[cell] = edge;
  };
  for (std::uint32_t edge = 0; edge < count(); ++edge) {
    const glm::vec2 from = points_[edge], way = points_[edge + 1] - from;
    const auto steps = static_cast<std::int32_t>(2 * glm::length(way) / cell_) + 1;
    for (std::int32_t k = 0; k <= steps; ++k) {
      const glm::vec2 at = (from + way * (static_cast<float>(k) / static_cast<float>(steps)) - glm::vec2(low_)) / cell_;
      offer(static_cast<std::int32_t>(at.x), static_cast<std::int32_t>(at.y), edge);
    }
  }
  const auto known = [&](std::int32_t x, std::int32_t y) {
    return x < 0 || y < 0 || x >= across_ || y >= up_ ? unknown : nearest_[static_cast<std::size_t>(y * across_ + x)];
  };
  for (std::int32_t sweep = 0; sweep < 2; ++sweep) {
    const std::int32_t back = sweep == 0 ? -1 : 1;
    for (std::int32_t row = 0; row < up_; ++row) {
      const std::int32_t y = sweep == 0 ? row : up_ - 1 - row;
      for (std::int32_t k = 0; k < across_; ++k) {
        const std::int32_t x = sweep == 0 ? k : across_ - 1 - k;
        offer(x, y, known(x + back, y));
        for (std::int32_t sideways = -1; sideways <= 1; ++sideways) offer(x, y, known(x + sideways, y + back));
      }
      for (std::int32_t k = 0; k < across_; ++k) {
        const std::int32_t x = sweep == 0 ? across_ - 1 - k : k;
        offer(x, y, known(x - back, y));
      }
    }
  }
}

// Reduces each cell's distance to a clearance that holds for the whole cell. Near the edge, where accuracy matters, all
// edges that may be nearer are tested.
void Outline::make_certain() {
  for (std::int32_t y = 0; y < up_; ++y)
    for (std::int32_t x = 0; x < across_; ++x) {
      float& free = clearance_[static_cast<std::size_t>(y * across_ + x)];
      if (free >= (near - 0.5f) * cell_) {
        free -= (to_corner + too_far) * cell_;
        continue;
      }
      const glm::vec3 middle = low_ + cell_ * glm::vec3(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 0);
      for (std::int32_t row = std::max(y - near, 0); row <= std::min(y + near, up_ - 1); ++row)
        for (std::uint32_t
                 k = first_in_[static_cast<std::size_t>(row * across_ + std::max(x - near, 0))],
                 end = first_in_[static_cast<std::size_t>(row * across_ + std::min(x + near, across_ - 1)) + 1];
             k < end; ++k)
          free = std::min(free, distance_to_edge(middle, edges_in_[k]));
      free = std::max(0.0f, free - to_corner * cell_);
    }
}

// The approximate distance from the edge: exact to the edge that is nearest to the cell's middle.
float Outline::about_distance(const glm::vec3& p) const {
  return distance_to_edge(p, nearest_[static_cast<std::size_t>(line_of(p.y) * across_ + column_of(p.x))]);
}

// A distance within which there is certainly no edge; 0 outside the grid.
float Outline::clearance(const glm::vec3& p) const {
  const glm::vec3 at = (p - low_) / cell_;
  if (!(at.x >= 0 && at.y >= 0)) return 0;
  const auto x = static_cast<std::int32_t>(std::min(at.x, 1e6f)), y = static_cast<std::int32_t>(std::min(at.y, 1e6f));
  return x < across_ && y < up_ ? clearance_[static_cast<std::size_t>(y * across_ + x)] : 0;
}

// The polygon's area, by the shoelace formula.
float Outline::area() const {
  float twice = 0;
  for (std::size_t i = 0; i < count(); ++i) twice += cross(points_[i], points_[i + 1]);
  return 0.5f * std::fabs(twice);
}

}  // namespace panicle::particles
