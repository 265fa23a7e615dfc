#include "models/grammar/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "light/density_grid.hpp"

namespace panicle::grammar {

// The turtle is the moving pen that draws a string.

namespace {

constexpr float own = 1e-3f;          // as a share of the radius: nearer ends are the turtle's own
constexpr std::size_t max_radii = 8;  // number of radii whose cells are cached at a time
constexpr float max_cells = 48;       // along an edge of the box
constexpr std::uint32_t lamps = 24;
constexpr float matter_of_an_end = 0.5f;  // as a share of a cell's side

}  // namespace

// Begins a pass in which queries are answered with the lines observed before.
void Neighbours::responses_begin() {
  answering_ = true;
  cells_.clear();
}

// Begins a pass in which the ends of lines are recorded.
void Neighbours::observation_begins() {
  answering_ = false;
  ends_.clear();
}

// Records the end of a line.
void Neighbours::line(std::int32_t, const lsystem::Turtle&, const lsystem::Turtle& after, const lsystem::Lineage&) {
  if (!answering_) ends_.push_back(after.position);
}

// Answers a query with a radius: how many ends of branches are within it, and how much light there is.
void Neighbours::query(const lsystem::Turtle& turtle, std::span<float> parameters, const lsystem::Lineage&) {
  if (!answering_ || parameters.size() < 2 || !(parameters[0] > 0) || !std::isfinite(parameters[0])) return;
  if (!budget_.spend(1)) return;
  const float radius = parameters[0];
  Cells& near = cells(radius);
  std::uint32_t count = 0, looked = 0;
  near.grid.visit(turtle.position, [&](std::uint32_t index) {
    ++looked;
    const float distance = glm::distance(ends_[index], turtle.position);
    if (distance <= radius && distance > own * radius) ++count;
  });
  budget_.spend(looked / 8);
  parameters[1] = static_cast<float>(count);
  if (parameters.size() < 3) return;
  if (near.light == nullptr) near.light = light(radius);
  parameters[2] = std::min(1.0f, near.light->at(turtle.position));
}

// The ends sorted into cells of that edge; the last few radii are cached.
Neighbours::Cells& Neighbours::cells(float edge) {
  for (Cells& cached : cells_)
    if (cached.edge == edge) return cached;
  if (cells_.size() == max_radii) cells_.erase(cells_.begin());
  budget_.spend(4 + 2 * ends_.size());
  cells_.push_back({edge, PointGrid(ends_, edge), nullptr});
  return cells_.back();
}

// Computes the light of an overcast sky among the ends of branches, in cells of `edge` metres at least.
std::unique_ptr<VoxelLight> Neighbours::light(float edge) const {
  glm::vec3 low(0), high(0);
  for (const glm::vec3& end : ends_) {
    low = glm::min(low, end);
    high = glm::max(high, end);
  }
  // A margin of at least half a cell: places above the box are fully lit.
  low -= edge;
  high += edge;
  const glm::vec3 size = high - low;
  const float cell = std::max(edge, std::max({size.x, size.y, size.z}) / max_cells);
  DensityGrid matter(low, high, cell);
  budget_.spend(ends_.size() + matter.cells() * lamps / 8);
  for (const glm::vec3& end : ends_) matter.put(end, matter_of_an_end * cell * cell);
  return std::make_unique<VoxelLight>(matter.light(overcast(lamps)));
}

}  // namespace panicle::grammar
