#include "models/growth/crown_light.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/mathematics.hpp"
#include "models/growth/volume_shape.hpp"

namespace panicle::growth {
namespace {

constexpr float cells = 6;  // along the longest edge of the volumes' bounding box
constexpr std::uint32_t sky_directions = 64;
// The sky as few directions: one from above, and some around at one height (degrees) and with equal shares.
constexpr int side_count = 4;
constexpr float side_height = 40, side_share = 0.18f;
constexpr float contrast = 1.5f;  // weight of a gradient from dark to full light within a cell, against the open sky

// Makes an empty grid of cells over all growth volumes, with a margin of one cell.
DensityGrid cells_of(const Population& population) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  for (const GrowthVolume& volume : population.volumes) {
    const glm::vec3 top = volume.at + volume.height * VolumeShape(volume).axis();
    const float half_width = 0.5f * std::max(volume.base, volume.top);
    const glm::vec3 margin(half_width, 0, half_width);
    low = glm::min(low, glm::min(volume.at, top) - margin);
    high = glm::max(high, glm::max(volume.at, top) + margin);
  }
  if (!(low.x <= high.x)) low = high = glm::vec3(0);
  const glm::vec3 size = high - low;
  const float edge = std::max({size.x, size.y, size.z, 1e-3f}) / cells;
  return {low - edge, high + edge, edge};
}

// Returns the sky's few directions; those of the sides are evenly spaced, else trees would lean.
std::vector<LightDirection> even_directions() {
  std::vector<LightDirection> directions{{{0, 1, 0}, 1 - side_share * side_count}};
  const SinCos height = sincos_degrees(side_height);
  for (int i = 0; i < side_count; ++i) {
    const SinCos azimuth = sincos_degrees(360.0f * static_cast<float>(i) / side_count);
    directions.push_back({{height.cosine * azimuth.cosine, height.sine, height.cosine * azimuth.sine}, side_share});
  }
  return directions;
}

}  // namespace

// Sets the direction of the visible sky: straight up, or with surroundings the mean of the directions above the
// horizon.
CrownLight::CrownLight(const Population& population, const Surroundings& surroundings)
    : matter_(cells_of(population)), directions_(surroundings.dimmed(even_directions())) {
  // The mean direction of light, each weighted by its share; not normalised.
  const auto mean = [](const std::vector<LightDirection>& directions) {
    glm::vec3 sum(0);
    for (const LightDirection& direction : directions) sum += direction.share * direction.towards;
    return sum;
  };
  if (surroundings.is_open()) return;
  // The horizon hides a direction or does not: with as few directions as the cells use, the mean would change in jumps.
  const std::vector<LightDirection> sky = overcast(sky_directions);
  const glm::vec3 full_sky = mean(sky), visible_sky = mean(surroundings.dimmed(sky));
  // The directions of `overcast` are a spiral whose mean is not exactly vertical.
  const glm::vec3 unbiased = visible_sky - glm::vec3(full_sky.x, 0, full_sky.z);
  // A sky that is dark all around would leave only that deviation.
  if (visible_sky.y > 1e-2f) sky_ = glm::normalize(unbiased);
}

// Adds an opaque area (m²) at a place to the cells.
void CrownLight::put(const glm::vec3& place, float area) { matter_.put(place, area); }

// Recomputes the light in all cells.
void CrownLight::update() { light_.emplace(matter_.light(directions_)); }

// The unit vector from a place towards the light: the direction of the visible sky, turned towards the cells that are
// lighter.
glm::vec3 CrownLight::from(const glm::vec3& place) const {
  if (!light_) return sky_;
  const glm::vec3 direction = sky_ + contrast * light_->edge() * light_->ascent(place);
  const float length = glm::length(direction);
  return length > 1e-3f ? direction / length : sky_;
}

}  // namespace panicle::growth
