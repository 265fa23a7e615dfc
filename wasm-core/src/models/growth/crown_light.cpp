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
// The sky as few directions: one from above, and some around at one height and with equal shares.
constexpr int about_count = 4;
constexpr float about_height = 40, about_share = 0.18f;
constexpr float contrast = 1.5f;  // weight of a gradient from dark to full light within a cell, against the open sky

DensityGrid cells_of(const Population& population) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  for (const GrowthVolume& volume : population.volumes) {
    const glm::vec3 top = volume.at + volume.height * VolumeShape(volume).axis();
    const float wide = 0.5f * std::max(volume.base, volume.top);
    const glm::vec3 about(wide, 0, wide);
    low = glm::min(low, glm::min(volume.at, top) - about);
    high = glm::max(high, glm::max(volume.at, top) + about);
  }
  if (!(low.x <= high.x)) low = high = glm::vec3(0);
  const glm::vec3 size = high - low;
  const float edge = std::max({size.x, size.y, size.z, 1e-3f}) / cells;
  return {low - edge, high + edge, edge};
}

// Evenly spaced around, few as they are: else trees would lean.
std::vector<LightDirection> even_directions() {
  std::vector<LightDirection> directions{{{0, 1, 0}, 1 - about_share * about_count}};
  const SinCos high = sincos_degrees(about_height);
  for (int i = 0; i < about_count; ++i) {
    const SinCos way = sincos_degrees(360.0f * static_cast<float>(i) / about_count);
    directions.push_back({{high.cosine * way.cosine, high.sine, high.cosine * way.sine}, about_share});
  }
  return directions;
}

}  // namespace

CrownLight::CrownLight(const Population& population, const Surroundings& about)
    : matter_(cells_of(population)), directions_(about.dimmed(even_directions())) {
  const auto middle = [](const std::vector<LightDirection>& directions) {
    glm::vec3 sum(0);
    for (const LightDirection& direction : directions) sum += direction.share * direction.towards;
    return sum;
  };
  if (about.is_open()) return;
  // The directions of `overcast` are a spiral whose mean is not exactly vertical.
  const glm::vec3 whole = middle(overcast(sky_directions)), open = middle(about.dimmed(overcast(sky_directions)));
  const glm::vec3 level = open - glm::vec3(whole.x, 0, whole.z);
  // A sky that is dark all around would leave only that deviation.
  if (open.y > 1e-2f) sky_ = glm::normalize(level);
}

void CrownLight::put(const glm::vec3& place, float area) { matter_.put(place, area); }

void CrownLight::update() { light_.emplace(matter_.light(directions_)); }

glm::vec3 CrownLight::from(const glm::vec3& place) const {
  if (!light_) return sky_;
  const glm::vec3 all = sky_ + contrast * light_->edge() * light_->ascent(place);
  const float length = glm::length(all);
  return length > 1e-3f ? all / length : sky_;
}

}  // namespace panicle::growth
