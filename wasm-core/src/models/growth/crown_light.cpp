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
constexpr std::uint32_t directions = 16, sky_directions = 64;
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
  const auto middle = [](const std::vector<Lamp>& lamps) {
    glm::vec3 sum(0);
    for (const Lamp& lamp : lamps) sum += lamp.share * lamp.towards;
    return sum;
  };
  if (about.alone()) return;
  // A spiral's own middle is not quite above.
  const glm::vec3 whole = middle(overcast(sky_directions)), open = middle(about.sky(sky_directions));
  const glm::vec3 level = open - glm::vec3(whole.x, 0, whole.z);
  if (glm::length(level) > 1e-3f) sky_ = glm::normalize(level);
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
