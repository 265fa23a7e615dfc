#include "models/grammar/measures/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "foundation/vectors.hpp"
#include "mesh/normals.hpp"
#include "mesh/polygon.hpp"
#include "models/grammar/measures/axes.hpp"
#include "models/grammar/measures/leaf_coverage.hpp"
#include "models/grammar/measures/measures.generated.hpp"
#include "models/grammar/surfaces.hpp"
#include "plant/branching.hpp"
#include "plant/measures.hpp"

namespace panicle::grammar {
namespace {

// Whether a tag is a surface of the material of blades.
bool is_leaf(std::uint32_t tag) {
  return tag >= first_surface_tag && surfaces[tag - first_surface_tag].material == "blade";
}

// A bounding box that grows.
class Box {
 public:
  // Extends the box to a ball of radius `about`.
  void add(const glm::vec3& place, float about = 0) {
    low_ = glm::min(low_, place - about);
    high_ = glm::max(high_, place + about);
  }
  // Size; 0 for an empty box.
  glm::dvec3 size() const { return low_.x <= high_.x ? glm::dvec3(high_ - low_) : glm::dvec3(0); }

 private:
  glm::vec3 low_{std::numeric_limits<float>::max()}, high_{-std::numeric_limits<float>::max()};
};

// The bounding box of lines, organs and polygons, in metres. Surfaces count as points at their bases.
Box box_of(const Plant& plant, const Sketch& sketch, float metres) {
  Box box;
  for (const Segment& segment : plant.segments) {
    box.add(segment.start);
    box.add(segment.end);
  }
  for (const Organ& organ : plant.organs)
    if (organ.tag != polygon_tag) box.add(organ.position, organ.tag == ball_tag ? std::fabs(organ.scale) : 0);
  for (const glm::vec3& corner : sketch.polygons.corners) box.add(metres * corner);
  return box;
}

// The area of a triangle.
double area_of(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return static_cast<double>(triangle_area(a, b, c));
}

// Area of a surface at size 1.
double area_of_surface(std::uint32_t which) {
  const Mesh leaf = make_surface(which);
  const auto at = [&](std::size_t i) { return vector_at(leaf.positions, leaf.indices[i]); };
  double sum = 0;
  for (std::size_t i = 0; i + 2 < leaf.indices.size(); i += 3) sum += area_of(at(i), at(i + 1), at(i + 2));
  return sum;
}

// Area of all polygons and leaves, in square metres.
double leaf_area(const Plant& plant, const Polygons& polygons, double metres, WorkBudget* budget) {
  double filled = 0, surface_area = 0;
  std::array<double, surfaces.size()> squares{};
  for (const Polygon& polygon : polygons.all) {
    const auto corners = std::span(polygons.corners).subspan(polygon.first, polygon.count);
    const std::vector<std::uint32_t> triangles = fill_polygon(corners, budget);
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
      filled += area_of(corners[triangles[i]], corners[triangles[i + 1]], corners[triangles[i + 2]]);
  }
  for (const Organ& organ : plant.organs)
    if (is_leaf(organ.tag))
      squares[organ.tag - first_surface_tag] += static_cast<double>(organ.scale) * static_cast<double>(organ.scale);
  for (std::uint32_t which = 0; which < surfaces.size(); ++which)
    if (squares[which] > 0) surface_area += squares[which] * area_of_surface(which);
  return filled * metres * metres + surface_area;
}

// Measures the areas: volumes, and the share of each surface that leaves cover.
void measure_areas(Plant& plant, const Areas& areas, Measures<Measure>& values) {
  if (areas.size() == 0) return;
  std::vector<Leaf> leaves;
  for (const Organ& organ : plant.organs)
    if (is_leaf(organ.tag)) leaves.push_back({organ.position, std::fabs(organ.scale)});
  const LeafCoverage coverage(std::move(leaves));
  std::vector<float> volumes, clothed;
  double whole = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    volumes.push_back(static_cast<float>(areas.volume(i)));
    whole += areas.volume(i);
    clothed.push_back(coverage.share_of(areas.surface(i)));
  }
  values.set(Measure::areas, static_cast<double>(areas.size()));
  values.set(Measure::area_volume, whole);
  values.set(Measure::clothed, *std::min_element(clothed.begin(), clothed.end()));
  plant.columns.add("areas.volume", std::move(volumes));
  plant.columns.add("areas.clothed", std::move(clothed));
}

}  // namespace

// Measures the plant: sizes, branching, organs, leaf area and the areas to grow into.
void measure(Plant& plant, const MeasureInput& input) {
  Measures<Measure> values(measure_count);
  const Sketch& sketch = input.sketch;
  const glm::dvec3 size = box_of(plant, sketch, input.metres).size();
  values.set(Measure::height, 100 * size.y);
  values.set(Measure::spread, 50 * (size.x + size.z));
  values.set(Measure::box_volume, 1000 * size.x * size.y * size.z);
  const Branching branching = branching_of(plant.segments);
  values.set(Measure::modules, static_cast<double>(lsystem::length(input.string)));
  values.set(Measure::segments, static_cast<double>(plant.segments.size()));
  values.set(Measure::line_length, branching.length);
  values.set(Measure::line_volume, 1e6 * branching.volume);
  if (!plant.segments.empty()) {
    const Axes axes = axes_of(input.string, sketch.lines);
    values.set(Measure::tips, branching.tips);
    values.set(Measure::forks, branching.forks);
    values.set(Measure::axes, axes.count);
    values.set(Measure::axis_order, axes.highest);
    values.set(Measure::order, branching.order);
    values.set(Measure::bifurcation, branching.bifurcation);
    values.set(Measure::fork_angle, branching.fork_angle);
  }
  values.set(Measure::organs, static_cast<double>(plant.organs.size()));
  values.set(Measure::polygons, static_cast<double>(sketch.polygons.all.size()));
  values.set(Measure::leaf_area, 1e4 * leaf_area(plant, sketch.polygons, input.metres, input.budget));
  measure_areas(plant, input.areas, values);
  plant.measures = values.take();
}

}  // namespace panicle::grammar
