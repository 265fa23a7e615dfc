#include "models/growth/crown_light.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "models/growth/form.hpp"

namespace panicle::growth {
namespace {

constexpr float cells = 8;  // along the longest edge of what the volumes take
constexpr std::uint32_t directions = 12, sky_directions = 64;
constexpr float contrast = 1.5f;  // what light that grows from dark to full in an edge counts against the sky

MatterCells cells_of(const Population& population) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  for (const GrowthVolume& volume : population.volumes) {
    const glm::vec3 top = volume.at + volume.height * axis_of(volume);
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

}  // namespace

CrownLight::CrownLight(const Population& population, const Surroundings& about)
    : matter_(cells_of(population)), lamps_(about.sky(directions)) {
  glm::vec3 sum(0);
  for (const Lamp& lamp : about.sky(sky_directions)) sum += lamp.share * lamp.towards;
  if (about.alone() || !(glm::length(sum) > 1e-3f)) return;
  sky_ = glm::normalize(sum);
}

void CrownLight::put(const glm::vec3& place, float area) { matter_.put(place, area); }

void CrownLight::shine() { light_.emplace(matter_.light(lamps_)); }

glm::vec3 CrownLight::from(const glm::vec3& place) const {
  if (!light_) return sky_;
  const glm::vec3 all = sky_ + contrast * light_->edge() * light_->ascent(place);
  const float length = glm::length(all);
  return length > 1e-3f ? all / length : sky_;
}

}  // namespace panicle::growth
