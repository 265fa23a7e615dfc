#include "models/leaf/blade_points.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "foundation/easing.hpp"
#include "foundation/order.hpp"
#include "mesh/triangulation.hpp"

namespace panicle::particles::leaf {
namespace {

// At detail 1: points of the lattice; length of veins with points of their own, in the lattice's spacings.
constexpr float lattice_points = 2200, vein_points = 1500;
constexpr float margin_within = 0.0004f;  // leaf lengths that the ring may be off
constexpr float apart = 0.6f;             // of the spacing: a lattice point nearer to another point is left out
constexpr float row_share = 0.866025f;    // of a lattice of equal triangles
constexpr float along_vein = 0.6f;        // of the spacing, between places on a vein

// Rounds a point to the lattice of the triangulation, whose tests are exact there.
glm::vec2 snap_to_lattice(const glm::vec2& p) {
  return glm::floor(p * triangulation_lattice + 0.5f) / triangulation_lattice;
}

// Removes points of a closed ring that are at most `within` off the line between those that remain.
std::vector<glm::vec2> simplified(std::span<const glm::vec2> ring, float within) {
  std::vector<glm::vec2> retained;
  std::size_t last = 0;
  // The largest distance of the points between two points from the line between these.
  const auto off = [&](std::size_t from, std::size_t to) {
    float most = 0;
    const glm::vec2 a = ring[from], way = ring[to % ring.size()] - a;
    const float square = glm::dot(way, way);
    for (std::size_t k = from + 1; k < to; ++k) {
      const float t = square > 0 ? glm::clamp(glm::dot(ring[k] - a, way) / square, 0.0f, 1.0f) : 0;
      most = std::max(most, glm::distance(ring[k] - a, t * way));
    }
    return most;
  };
  retained.push_back(ring[0]);
  for (std::size_t i = 2; i <= ring.size(); ++i) {
    if (i - last <= 16 && off(last, i) <= within) continue;
    retained.push_back(ring[i - 1]);
    last = i - 1;
  }
  return retained;
}

// A grid of points, for checking whether there is room for another one. `cell` is the cells' width.
class PointCells {
 public:
  PointCells(const glm::vec2& low, const glm::vec2& high, float cell)
      : low_(low),
        cell_(cell),
        across_(static_cast<std::int32_t>((high.x - low.x) / cell) + 1),
        up_(static_cast<std::int32_t>((high.y - low.y) / cell) + 1),
        cells_(static_cast<std::size_t>(across_ * up_)) {}

  // Adds a point to its cell.
  void add(const glm::vec2& p) { cells_[index(column(p.x), row(p.y))].push_back(p); }
  // Whether no point is nearer to p than `reach`, which is at most a cell's width.
  bool room(const glm::vec2& p, float reach) const {
    for (std::int32_t y = std::max(row(p.y) - 1, 0); y <= std::min(row(p.y) + 1, up_ - 1); ++y)
      for (std::int32_t x = std::max(column(p.x) - 1, 0); x <= std::min(column(p.x) + 1, across_ - 1); ++x)
        for (const glm::vec2& other : cells_[index(x, y)]) {
          const glm::vec2 way = other - p;
          if (glm::dot(way, way) < reach * reach) return false;
        }
    return true;
  }

 private:
  // The column and row of cells at a coordinate, and a cell's index.
  std::int32_t column(float x) const {
    return std::clamp(static_cast<std::int32_t>((x - low_.x) / cell_), 0, across_ - 1);
  }
  std::int32_t row(float y) const { return std::clamp(static_cast<std::int32_t>((y - low_.y) / cell_), 0, up_ - 1); }
  std::size_t index(std::int32_t x, std::int32_t y) const { return static_cast<std::size_t>(y * across_ + x); }

  glm::vec2 low_;
  float cell_;
  std::int32_t across_, up_;
  std::vector<std::vector<glm::vec2>> cells_;
};

// The widest pieces of veins, up to a total length.
std::vector<VeinPiece> widest(std::span<const VeinPiece> veins, float length) {
  std::vector<float> narrowness;
  for (const VeinPiece& vein : veins) narrowness.push_back(-vein.radius_from);
  std::vector<VeinPiece> retained;
  float sum = 0;
  for (const std::uint32_t i : order_of(narrowness)) {
    if (!(sum < length)) break;
    retained.push_back(veins[i]);
    sum += glm::distance(veins[i].from, veins[i].to);
  }
  return retained;
}

}  // namespace

// Places the points of a blade that are triangulated: the simplified margin first, then points along the wider veins,
// then a lattice over the rest. A point is left out where others are too near.
BladePoints place_points(const Margin& margin, const Outline& outline, std::span<const VeinPiece> veins, float detail) {
  const glm::vec2 low(outline.low().x, outline.low().y), high(outline.high().x, outline.high().y);
  const float spacing = std::sqrt(outline.area() / (lattice_points * detail));
  BladePoints blade;
  blade.points = simplified(margin.points, margin_within / detail);
  if (crossing(blade.points).first != crossing(blade.points).second) blade.points = margin.points;
  blade.ring = blade.points.size();
  PointCells point_cells(low, high, spacing);
  for (std::size_t i = 0; i < blade.ring; ++i) {
    // Also points along the ring's edges, so that other points keep off long edges too.
    const glm::vec2 a = blade.points[i], b = blade.points[(i + 1) % blade.ring];
    const float count = std::max(1.0f, std::ceil(2 * glm::distance(a, b) / spacing));
    for (float k = 0; k < count; ++k) point_cells.add(a + (k / count) * (b - a));
  }
  const auto add = [&](const glm::vec2& p, float reach) {
    if (!point_cells.room(p, reach) || !outline.contains({p.x, p.y, 0})) return;
    point_cells.add(p);
    blade.points.push_back(snap_to_lattice(p));
  };
  const std::vector<VeinPiece> shown_veins = widest(veins, vein_points * detail * along_vein * spacing);
  for (const VeinPiece& vein : shown_veins) {
    const float length = glm::distance(vein.from, vein.to);
    if (!(length > 0)) continue;
    const glm::vec2 way = (vein.to - vein.from) / length, across(-way.y, way.x);
    const float count = std::max(1.0f, std::ceil(length / (along_vein * spacing)));
    for (float k = 0.5f; k < count; ++k) {
      const float t = k / count, radius = vein.radius_from + t * (vein.radius_to - vein.radius_from);
      const glm::vec2 axis = vein.from + t * (vein.to - vein.from);
      const float beside = std::min(radius, spacing);
      add(axis, 0.5f * beside);
      add(axis + beside * across, 0.6f * beside);
      add(axis - beside * across, 0.6f * beside);
    }
  }
  for (std::int32_t row = 0; low.y + static_cast<float>(row) * row_share * spacing < high.y; ++row)
    for (float x = low.x + (row % 2 ? 0.5f : 0.0f) * spacing; x < high.x; x += spacing)
      add({x, low.y + static_cast<float>(row) * row_share * spacing}, apart * spacing);

  // Raises the points near each vein.
  blade.rise.assign(blade.points.size(), 0);
  const float cell = 2 * spacing;
  const auto across = static_cast<std::int32_t>((high.x - low.x) / cell) + 1,
             up = static_cast<std::int32_t>((high.y - low.y) / cell) + 1;
  const auto column = [&](float x) { return std::clamp(static_cast<std::int32_t>((x - low.x) / cell), 0, across - 1); };
  const auto row = [&](float y) { return std::clamp(static_cast<std::int32_t>((y - low.y) / cell), 0, up - 1); };
  std::vector<std::vector<std::uint32_t>> by_cell(static_cast<std::size_t>(across * up));
  for (std::uint32_t i = 0; i < blade.points.size(); ++i)
    by_cell[static_cast<std::size_t>(row(blade.points[i].y) * across + column(blade.points[i].x))].push_back(i);
  for (const VeinPiece& vein : shown_veins) {
    const float reach = std::max(vein.radius_from, vein.radius_to);
    const glm::vec2 from = glm::min(vein.from, vein.to) - reach, to = glm::max(vein.from, vein.to) + reach;
    const glm::vec2 way = vein.to - vein.from;
    const float square = glm::dot(way, way);
    for (std::int32_t y = row(from.y); y <= row(to.y); ++y)
      for (std::int32_t x = column(from.x); x <= column(to.x); ++x)
        for (const std::uint32_t i : by_cell[static_cast<std::size_t>(y * across + x)]) {
          const float t = square > 0 ? glm::clamp(glm::dot(blade.points[i] - vein.from, way) / square, 0.0f, 1.0f) : 0;
          const float radius = vein.radius_from + t * (vein.radius_to - vein.radius_from);
          const float share = hill(glm::distance(blade.points[i], vein.from + t * way) / std::max(radius, 1e-9f));
          blade.rise[i] = std::max(blade.rise[i], share * radius);
        }
  }
  return blade;
}

}  // namespace panicle::particles::leaf
