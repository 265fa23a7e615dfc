#include "spatial/solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "foundation/lanes.hpp"
#include "foundation/mathematics.hpp"

namespace panicle {
namespace {

constexpr float cells_along = 64;  // the edge of a cube as large as the box
constexpr float max_along = 4096;
constexpr float max_cells = 400'000;
constexpr float least_edge = 1e-30f;     // of a cell, where all points coincide
constexpr float half_diagonal = 0.867f;  // of a cell, in edges
constexpr float slack = 1e-3f;           // for rounding, in edges
constexpr std::uint32_t lanes = 4;
constexpr float piece = 4;       // of a way that is looked at in one go, in edges
constexpr float beside = 1e-4f;  // of a triangle, that still meets it: the way between two must meet one of them
constexpr int halvings = 24;
// The rows that the boxes of all triangles may meet, over the number of entries that the index may have: each is tested
// for an entry.
constexpr std::size_t rows_per_entry = 4;
constexpr float wider = 1.25f;  // factor of the cells' edge while there are too many cells or entries
// Costs in examined triangles: of a test whether four triangles meet a slice, of the turns that one adds, and of an
// intersection with a ray.
constexpr std::uint64_t looks_four = 1, looks_turn = 8, looks_meeting = 4;
// A bound of the rounding error of a distance to a plane, as a share of the coordinates.
constexpr float rounding = 4e-6f;

}  // namespace

// Builds a solid from a closed surface, with a grid of cells that are known to be inside, outside or mixed. Queries
// count against the budget.
Solid::Solid(Surface surface, std::shared_ptr<QueryBudget> budget)
    : surface_(std::move(surface)), budget_(std::move(budget)) {
  const std::vector<glm::vec3>& points = surface_.points;
  if (points.empty()) return;
  low_ = high_ = points[0];
  for (const glm::vec3& p : points) {
    low_ = glm::min(low_, p);
    high_ = glm::max(high_, p);
  }
  choose_cells();
  classify();
}

// Chooses the width of the grid's cells: as fine as the limits of cells and of index entries allow.
void Solid::choose_cells() {
  const glm::vec3 size = high_ - low_;
  const float longest = std::max({size.x, size.y, size.z});
  edge_ = std::max({cube_root(size.x * size.y * size.z) / cells_along, longest / max_along, least_edge});
  const auto cells = [&] { return (size.x / edge_ + 1) * (size.y / edge_ + 1) * (size.z / edge_ + 1); };
  while (cells() > max_cells) edge_ *= wider;
  // A single row has an entry for each triangle, so the loop ends.
  const std::size_t most = std::max(budget_->members_each(), surface_.triangles.size() / 3);
  std::vector<Entry> entries;
  for (bool fits = false; !fits;) {
    per_edge_ = 1 / edge_;
    count_ = glm::ivec3(size * per_edge_) + 1;
    fits = list_entries(most, entries);
    if (!fits) edge_ *= wider;
  }
  build_row_index(entries);
}

// The range of cells that a triangle's box meets.
Solid::CellBox Solid::cells_around(const std::uint32_t* corners) const {
  const auto corner = [&](std::size_t k) { return cell_of(surface_.points[corners[k]]); };
  const glm::ivec3 a = corner(0), b = corner(1), c = corner(2);
  return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

// Lists for each triangle the rows of cells (along x) that it may meet. Returns false if there are more than `most`.
bool Solid::list_entries(std::size_t most, std::vector<Entry>& entries) const {
  entries.clear();
  std::size_t rows = 0;  // that the boxes of all triangles meet
  for (std::size_t t = 0; t + 2 < surface_.triangles.size(); t += 3) {
    const auto [low, high] = cells_around(&surface_.triangles[t]);
    rows += static_cast<std::size_t>(high.y - low.y + 1) * static_cast<std::size_t>(high.z - low.z + 1);
  }
  if (rows > most * rows_per_entry) return false;
  const glm::vec3 extent = glm::max(glm::abs(low_), glm::abs(high_));
  const float lost = rounding * (extent.x + extent.y + extent.z);
  for (std::uint32_t t = 0; t < surface_.triangles.size() / 3; ++t) {
    const std::uint32_t* const corners = &surface_.triangles[3 * t];
    const auto [from, to] = cells_around(corners);
    if (from.y == to.y || from.z == to.z) {
      for (int z = from.z; z <= to.z; ++z)
        for (int y = from.y; y <= to.y; ++y) entries.push_back({row_at(y, z), t});
      continue;
    }
    // Seen along x, rows are squares. A row does not meet the triangle if it lies beyond one of its sides by more than
    // the tolerance with which a place beside the triangle still counts.
    std::array<Side, 3> sides;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3& a = surface_.points[corners[k]];
      const glm::vec3& b = surface_.points[corners[(k + 1) % 3]];
      const glm::vec3& c = surface_.points[corners[(k + 2) % 3]];
      Side& side = sides[k];
      side = {b.z - a.z, a.y - b.y, 0, 0};
      side.at = side.y * a.y + side.z * a.z;
      const float inside = side.y * c.y + side.z * c.z - side.at;
      if (inside < 0) side = {-side.y, -side.z, -side.at, 0};
      const float size = std::fabs(side.y) + std::fabs(side.z);
      side.near = size * ((0.5f + slack) * edge_ + 4 * lost) + 2 * beside * std::fabs(inside);
    }
    for (int z = from.z; z <= to.z; ++z)
      for (int y = from.y; y <= to.y; ++y) {
        const float middle_y = low_.y + edge_ * (static_cast<float>(y) + 0.5f),
                    middle_z = low_.z + edge_ * (static_cast<float>(z) + 0.5f);
        const auto beyond = [&](const Side& side) {
          return side.y * middle_y + side.z * middle_z - side.at < -side.near;
        };
        if (!beyond(sides[0]) && !beyond(sides[1]) && !beyond(sides[2])) entries.push_back({row_at(y, z), t});
      }
    if (entries.size() > most) return false;
  }
  return true;
}

// Builds the index from its entries: sorts the triangles by row, and finds the bounds that let queries skip them.
void Solid::build_row_index(const std::vector<Entry>& entries) {
  first_.assign(static_cast<std::size_t>(count_.y * count_.z) + 1, 0);
  for (const Entry& each : entries) ++first_[each.row + 1];
  for (std::size_t row = 1; row < first_.size(); ++row) first_[row] += first_[row - 1];
  members_.resize(first_.back());
  std::vector<std::uint32_t> free(first_.begin(), first_.end() - 1);
  for (const Entry& each : entries) members_[free[each.row]++] = each.triangle;
  for (auto* values : {&lowest_, &highest_, &farthest_}) values->assign(members_.size() + lanes - 1, 0);
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const auto corner = [&](std::size_t k) { return surface_.points[surface_.triangles[3 * members_[m] + k]]; };
    const glm::vec3 a = corner(0), b = corner(1), c = corner(2);
    lowest_[m] = std::min({a.y, b.y, c.y});
    highest_[m] = std::max({a.y, b.y, c.y});
    farthest_[m] = std::max({a.x, b.x, c.x}) + slack * edge_;
  }
}

// Marks the cells near a triangle as mixed; `unmarked` counts the other cells of each row.
void Solid::mark(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, std::vector<std::int32_t>& unmarked) {
  const float little = slack * edge_, reach = half_diagonal * edge_ + little;
  const glm::vec3 across = glm::cross(b - a, c - a);
  const float length = glm::length(across);
  const glm::vec3 normal = length > 0 ? across / length : glm::vec3(0);
  const glm::ivec3 from = cell_of(glm::max(glm::min(a, glm::min(b, c)) - little, low_)),
                   to = cell_of(glm::max(a, glm::max(b, c)) + little);
  const glm::vec3 extent = glm::max(glm::abs(low_), glm::abs(high_));
  const float lost = rounding * (extent.x + extent.y + extent.z), along = edge_ * normal.x;
  for (int z = from.z; z <= to.z; ++z)
    for (int y = from.y; y <= to.y; ++y) {
      std::int32_t& left = unmarked[static_cast<std::size_t>(z * count_.y + y)];
      if (left == 0) continue;
      // Along a row the distance to the plane changes evenly: only cells between two places can be near enough, which
      // are looked at one by one.
      const glm::vec3 first = low_ + edge_ * (glm::vec3(from.x, y, z) + 0.5f);
      const float distance = glm::dot(first - a, normal), near = reach + lost;
      int begin = from.x, end = to.x;
      if (std::fabs(along) * static_cast<float>(end - begin) <= lost) {
        if (std::fabs(distance) > near + lost) continue;
      } else {
        const float one = (-near - distance) / along, other = (near - distance) / along;
        const auto cells = static_cast<float>(end - begin);
        const float least = std::min(one, other) - 1, most = std::max(one, other) + 1;
        if (!(least <= cells && most >= 0)) continue;
        end = begin + static_cast<int>(std::min(most, cells));
        begin += static_cast<int>(std::max(least, 0.0f));
      }
      for (int x = begin; x <= end; ++x) {
        Cell& cell = cells_[cell_at({x, y, z})];
        if (cell == Cell::mixed) continue;
        const glm::vec3 middle = low_ + edge_ * (glm::vec3(x, y, z) + 0.5f);
        if (!(std::fabs(glm::dot(middle - a, normal)) <= reach)) continue;
        cell = Cell::mixed;
        --left;
      }
    }
}

// Marks the cells that triangles come near to, and classifies one cell in each run of the others.
void Solid::classify() {
  cells_.assign(cell_at({0, 0, count_.z}), Cell::unknown);
  std::vector<std::int32_t> unmarked(static_cast<std::size_t>(count_.y * count_.z), count_.x);
  for (std::size_t t = 0; t + 2 < surface_.triangles.size(); t += 3) {
    const auto corner = [&](std::size_t k) { return surface_.points[surface_.triangles[t + k]]; };
    mark(corner(0), corner(1), corner(2), unmarked);
  }
  for (int z = 0; z < count_.z; ++z)
    for (int y = 0; y < count_.y && !is_exhausted(); ++y) {
      Cell last = Cell::mixed;
      for (int x = 0; x < count_.x; ++x) {
        Cell& cell = cells_[cell_at({x, y, z})];
        if (cell == Cell::unknown) {
          if (last == Cell::mixed)
            last = slice_contains(low_ + edge_ * (glm::vec3(x, y, z) + 0.5f)) ? Cell::inside : Cell::outside;
          cell = last;
        }
        last = cell;
      }
    }
}

// Whether a point is inside; false once the budget is used up.
bool Solid::contains(const glm::vec3& p) const {
  for (int k = 0; k < 3; ++k)
    if (!(p[k] >= low_[k] && p[k] <= high_[k])) return false;
  if (cells_.empty() || is_exhausted()) return false;
  const Cell cell = cells_[cell_at(cell_of(p))];
  return cell == Cell::mixed ? slice_contains(p) : cell == Cell::inside;
}

// A bound for a box from the cells that it meets: all or none where these are all inside or all outside.
Share Solid::share_of(const glm::vec3& low, const glm::vec3& high) const {
  bool beyond = cells_.empty();
  for (int k = 0; k < 3; ++k) {
    if (!(low[k] <= high_[k] && high[k] >= low_[k])) return Share::none;
    beyond = beyond || low[k] < low_[k] || high[k] > high_[k];
  }
  if (beyond) return Share::some;
  const glm::ivec3 from = cell_of(low), to = cell_of(high);
  const Cell first = cells_[cell_at(from)];
  if (first == Cell::mixed) return Share::some;
  for (int z = from.z; z <= to.z; ++z)
    for (int y = from.y; y <= to.y; ++y)
      for (int x = from.x; x <= to.x; ++x)
        if (cells_[cell_at({x, y, z})] != first) return Share::some;
  return first == Cell::inside ? Share::all : Share::none;
}

// Whether the winding number at a point is not 0. Counts crossings on the ray from the point towards +x, so triangles
// that end before it add none, nor do those above or below.
bool Solid::slice_contains(const glm::vec3& p) const {
  int turns = 0;
  const glm::ivec3 place = cell_of(p);
  const auto row = static_cast<std::size_t>(place.z * count_.y + place.y);
  const std::uint32_t begin = first_[row], end = first_[row + 1];
  std::uint64_t turned = 0;
  for (std::uint32_t m = begin; m < end; m += lanes) {
    const auto met = (load(&lowest_[m]) <= p.y) & (load(&highest_[m]) > p.y) & (load(&farthest_[m]) >= p.x);
    if (all(~met)) continue;
    for (std::uint32_t lane = 0; lane < std::min(end - m, lanes); ++lane)
      if (met[lane]) {
        turns += winding_number(p, &surface_.triangles[3 * members_[m + lane]]);
        ++turned;
      }
  }
  budget_->spend(looks_four * (end - begin) / lanes + looks_turn * turned);
  return turns != 0;
}

// The winding number that one triangle adds at a point: 1, −1 or 0.
int Solid::winding_number(const glm::vec3& p, const std::uint32_t* corners) const {
  // Where the plane enters and leaves the triangle, in its own sense: corners at the plane's height count as below.
  glm::vec2 entering(0), leaving(0);
  int crossed = 0;
  for (int k = 0; k < 3; ++k) {
    const glm::vec3& a = surface_.points[corners[k]];
    const glm::vec3& b = surface_.points[corners[(k + 1) % 3]];
    const bool below = a.y <= p.y;
    if (below == (b.y <= p.y)) continue;
    // From the lower end, so that both triangles at an edge find the same place.
    const glm::vec3& lower = below ? a : b;
    const glm::vec3& upper = below ? b : a;
    const float at = (p.y - lower.y) / (upper.y - lower.y);
    (below ? entering : leaving) = {lower.x + at * (upper.x - lower.x), lower.z + at * (upper.z - lower.z)};
    ++crossed;
  }
  if (crossed != 2 || (entering.y <= p.z) == (leaving.y <= p.z)) return 0;
  const float side = (leaving.x - entering.x) * (p.z - entering.y) - (leaving.y - entering.y) * (p.x - entering.x);
  if (entering.y <= p.z) return side > 0 ? 1 : 0;
  return side < 0 ? -1 : 0;
}

// Appends the parameters t in (begin, end] at which the ray from + t way meets triangles, by Möller & Trumbore (1997),
// "Fast, minimum storage ray/triangle intersection".
void Solid::intersections(const glm::vec3& from, const glm::vec3& way, float begin, float end,
                          std::vector<float>& at) const {
  const glm::vec3 a = from + begin * way, b = from + end * way;
  const glm::vec3 low = glm::min(a, b) - slack * edge_, high = glm::max(a, b) + slack * edge_;
  for (int k = 0; k < 3; ++k)
    if (!(high[k] >= low_[k] && low[k] <= high_[k])) return;
  const glm::ivec3 first = cell_of(glm::max(low, low_)), last = cell_of(glm::min(high, high_));
  for (int z = first.z; z <= last.z; ++z)
    for (int y = first.y; y <= last.y; ++y) {
      const auto row = static_cast<std::size_t>(z * count_.y + y);
      budget_->spend(looks_meeting * (first_[row + 1] - first_[row]));
      for (std::uint32_t m = first_[row]; m < first_[row + 1]; ++m) {
        if (lowest_[m] > high.y || highest_[m] < low.y || farthest_[m] < low.x) continue;
        const std::uint32_t* corners = &surface_.triangles[3 * members_[m]];
        const glm::vec3& corner = surface_.points[corners[0]];
        const glm::vec3 one = surface_.points[corners[1]] - corner, other = surface_.points[corners[2]] - corner;
        const glm::vec3 across = glm::cross(way, other);
        const float volume = glm::dot(one, across);
        if (volume == 0) continue;
        const glm::vec3 to = from - corner, along = glm::cross(to, one);
        const float u = glm::dot(to, across) / volume, v = glm::dot(way, along) / volume;
        if (!(u >= -beside && v >= -beside && u + v <= 1 + beside)) continue;
        const float t = glm::dot(other, along) / volume;
        if (t > begin && t <= end) at.push_back(t);
      }
    }
}

// The distance from a point inside along a unit vector to the surface, `most` at most; 0 from outside. Tests the pieces
// of the ray between intersections: each is all inside or all outside, so its middle is tested. Edges hit twice,
// surfaces within and triangles seen edgewise then need no rules of their own.
float Solid::exit_distance(const glm::vec3& from, const glm::vec3& way, float most) const {
  if (!contains(from)) return 0;
  const auto inside = [&](float t) { return contains(from + t * way); };
  std::vector<float> hits;
  for (float begin = 0; begin < most;) {
    const float end = std::min(begin + piece * edge_, most);
    hits.clear();
    intersections(from, way, begin, end, hits);
    std::sort(hits.begin(), hits.end());
    hits.push_back(end);
    float last = begin;
    for (const float t : hits) {
      if (t > last && !inside(0.5f * (last + t))) return last;
      last = t;
    }
    // A ray through a gap that rounding leaves between two triangles has no intersection there.
    if (!inside(end)) {
      float low = hits.size() > 1 ? hits[hits.size() - 2] : begin, high = end;
      low = 0.5f * (low + high);
      for (int k = 0; k < halvings; ++k) (inside(0.5f * (low + high)) ? low : high) = 0.5f * (low + high);
      return low;
    }
    if (!(end > begin)) break;
    begin = end;
  }
  return most;
}

}  // namespace panicle
