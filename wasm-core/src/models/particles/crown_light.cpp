#include "models/particles/crown_light.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::particles {
namespace {

constexpr std::uint32_t directions = 24;
// Optical depth of a cell with a wall in it: it transmits e to the power of minus this.
constexpr float opaque = 6;
// Enough for a dozen crowns side by side, each as finely as one alone, and nearly as much again.
constexpr std::uint64_t max_cells = 400'000;
constexpr float max_along = 20'000, wider = 1.05f;

}  // namespace

// The directions from which light comes, with their shares of it: the overcast sky's and the sun's, mixed by
// `habit.sky`.
std::vector<LightDirection> light_directions(const LightHabit& habit) {
  std::vector<LightDirection> lamps;
  if (habit.sky > 0) lamps = overcast(directions);
  for (LightDirection& lamp : lamps) lamp.share *= habit.sky;
  if (habit.sky < 1) lamps.push_back({habit.sun, 1 - habit.sky});
  return lamps;
}

// The unit vector towards the sun, from its azimuth and its height above the horizon in degrees.
glm::vec3 towards_sun(float azimuth, float height) {
  const auto [sine, cosine] = sincos_degrees(azimuth);
  const auto [up, along] = sincos_degrees(height);
  return {along * sine, up, along * cosine};
}

// Builds the light in a grid of cells over a crown and the obstacles near it. `edge` is the cells' width, which grows
// until the grid has at most `max_cells`. Leaves absorb by the habit, walls nearly everything.
VoxelLight light_in(const Region& crown, const LightObstacles& shades, const LightHabit& habit, float edge) {
  glm::vec3 first = crown.low(), last = crown.high();
  // Obstacles about the crown count only for light that reaches this far.
  const glm::vec3 from = 2.0f * first - last, to = 2.0f * last - first;
  for (const std::span<const Box> some : {shades.crowns, shades.walls})
    for (const Box& box : some) {
      first = glm::min(first, glm::clamp(box.low, from, to));
      last = glm::max(last, glm::clamp(box.high, from, to));
    }
  const glm::vec3 size = last - first;
  const auto count = [&](float length) { return static_cast<std::uint32_t>(std::ceil(length / edge)) + 1; };
  edge = std::max({edge, glm::length(size) / max_along, 1e-6f});
  while (std::uint64_t{count(size.x)} * count(size.y) * count(size.z) > max_cells) edge *= wider;
  // The optical density at a point: absorption per unit of length.
  const auto matter_at = [&](const glm::vec3& p) {
    const auto walled = [&](const Box& wall) {
      return glm::all(glm::lessThan(glm::max(wall.low - p, p - wall.high), glm::vec3(0.5f * edge)));
    };
    if (std::any_of(shades.walls.begin(), shades.walls.end(), walled)) return opaque / edge;
    const auto within = [&](const Box& other) { return within_round(other, p); };
    const bool leafy = crown.contains(p) || std::any_of(shades.crowns.begin(), shades.crowns.end(), within);
    return leafy ? habit.absorption : 0;
  };
  const std::uint32_t x = count(size.x), y = count(size.y), z = count(size.z);
  const glm::vec3 low = first - 0.5f * edge;
  std::vector<float> matter;
  matter.reserve(std::size_t{x} * y * z);
  for (std::uint32_t k = 0; k < z; ++k)
    for (std::uint32_t j = 0; j < y; ++j)
      for (std::uint32_t i = 0; i < x; ++i) matter.push_back(matter_at(low + edge * (glm::vec3(i, j, k) + 0.5f)));
  return {low, edge, x, y, z, matter, light_directions(habit)};
}

}  // namespace panicle::particles
