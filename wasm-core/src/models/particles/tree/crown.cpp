#include "models/particles/tree/crown.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/mathematics.hpp"

namespace panicle::particles::tree {
namespace {

constexpr int probes = 24;

}  // namespace

Crowns make_crowns(const CrownHabit& habit, std::span<const glm::vec2> profile, const Surface& mesh) {
  const auto crowns = static_cast<float>(habit.crowns), stems = static_cast<float>(habit.stems);
  const glm::vec3 half = 0.5f * habit.growth * habit.size;
  const float lowest = habit.growth * habit.trunk;
  const float shoots = habit.inner + (1 - habit.inner) * habit.shoots;
  Surface outer, inner;
  Crowns made{Solid({}), Solid({}), {}, 2 * half.y, lowest + (1 + shoots) * half.y, 0};
  made.across = cube_root(8 * half.x * half.y * half.z);
  for (float i = 0; i < crowns; ++i) {
    const float x = (i - 0.5f * (crowns - 1)) * habit.distance;
    const glm::vec3 middle(x, lowest + half.y, 0);
    const Surface whole = form_between(habit.form, profile, mesh, middle - half, middle + half);
    append(outer, scaled(whole, middle, shoots));
    if (habit.inner > 0) append(inner, scaled(whole, middle, habit.inner));
    for (float k = 0; k < stems; ++k) made.feet.emplace_back(x + 2 * half.x * ((k + 0.5f) / stems - 0.5f), 0, 0);
  }
  made.outer = Solid(std::move(outer));
  made.inner = Solid(std::move(inner));
  return made;
}

Foliage::Foliage(const Crowns& crowns, const VoxelLight* light, float heed, const Hormone& hormone)
    : crowns_(&crowns), light_(light), hormone_(&hormone), heed_(heed) {
  if (light_ == nullptr) return;
  brightest_ = 0;
  const glm::vec3 size = high() - low();
  for (int z = 0; z <= probes; ++z)
    for (int y = 0; y <= probes; ++y)
      for (int x = 0; x <= probes; ++x)
        brightest_ = std::max(brightest_, light_->at(low() + size * (glm::vec3(x, y, z) / static_cast<float>(probes))));
}

float Foliage::density(const glm::vec3& p) const {
  const float share = light_ ? std::min(light_->at(p) / brightest_, 1.0f) : 1;
  const float lit = heed_ == 1 ? share : power(share, heed_);
  return lit * hormone_->left(p);
}

}  // namespace panicle::particles::tree
