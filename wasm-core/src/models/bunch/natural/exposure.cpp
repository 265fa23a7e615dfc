#include "models/bunch/natural/exposure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "environment/point_grid.hpp"
#include "foundation/mathematics.hpp"
#include "models/bunch/fruit/projection.hpp"

namespace panicle::bunch {
namespace {

constexpr std::size_t samples = 37;  // of each disc
constexpr float penumbra = 0.25f;    // width of a shadow's edge, in radii of what casts it
constexpr float behind_at = 0.5f;    // by how many of its outer radii one berry lies before another to shade it in full
constexpr float golden_angle = 137.50776f;  // degrees

// Evenly over the unit disc: the sunflower's spiral (Vogel 1979).
std::array<glm::vec2, samples> even_disc() {
  std::array<glm::vec2, samples> points;
  for (std::size_t k = 0; k < samples; ++k) {
    const float radius = std::sqrt((static_cast<float>(k) + 0.5f) / samples);
    const SinCos turn = sincos_degrees(golden_angle * static_cast<float>(k));
    points[k] = {radius * turn.cosine, radius * turn.sine};
  }
  return points;
}

// Which berries may lie over a place of the picture: cells as wide as the widest berry with its penumbra.
PointGrid cells_of(std::span<const ProjectedBerry> berries) {
  std::vector<glm::vec3> places;
  float widest = 0;
  for (const ProjectedBerry& berry : berries) {
    places.emplace_back(berry.centre, 0);
    widest = std::max(widest, berry.outer);
  }
  return {places, 2 * (1 + penumbra / 2) * widest};
}

// Darkens the samples of `lit` by what `shading` casts on it.
void shade(const ProjectedBerry& lit, const ProjectedBerry& shading, std::span<const glm::vec2> disc,
           std::array<float, samples>& light) {
  const float before = std::min(1.0f, (shading.depth - lit.depth) / (behind_at * lit.outer));
  const glm::vec2 between = shading.centre - lit.centre;
  for (std::size_t k = 0; k < samples; ++k) {
    const float out = std::sqrt(shading.level(disc[k] - between));
    const float cover = (1 + penumbra / 2 - out) / penumbra;
    light[k] *= 1 - before * std::clamp(cover, 0.0f, 1.0f);
  }
}

}  // namespace

std::vector<float> sun_exposure(std::span<const BerryBody> berries, glm::vec3 towards_sun) {
  std::vector<float> exposure(berries.size(), 1.0f);
  if (berries.size() < 2) return exposure;
  const View view = view_from(towards_sun);
  std::vector<ProjectedBerry> seen(berries.size());
  for (std::size_t i = 0; i < berries.size(); ++i) seen[i] = project(berries[i], view);
  const PointGrid cells = cells_of(seen);
  const std::array<glm::vec2, samples> unit = even_disc();
  std::array<glm::vec2, samples> disc;
  std::array<float, samples> light;
  for (std::size_t i = 0; i < berries.size(); ++i) {
    const ProjectedBerry& lit = seen[i];
    for (std::size_t k = 0; k < samples; ++k) disc[k] = lit.on_disc(unit[k]);
    light.fill(1.0f);
    cells.visit({lit.centre, 0}, [&](std::uint32_t j) {
      const ProjectedBerry& other = seen[j];
      if (!(other.depth > lit.depth)) return;
      const glm::vec2 between = other.centre - lit.centre;
      const float reach = lit.outer + (1 + penumbra / 2) * other.outer;
      if (between.x * between.x + between.y * between.y < reach * reach) shade(lit, other, disc, light);
    });
    float sum = 0;
    for (const float share : light) sum += share;
    exposure[i] = sum / samples;
  }
  return exposure;
}

}  // namespace panicle::bunch
