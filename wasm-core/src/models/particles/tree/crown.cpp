#include "models/particles/tree/crown.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

namespace panicle::particles::tree {
namespace {

constexpr int probes = 24;
constexpr std::uint64_t stream_ragged = 0x4a99;
// Of the billows that a crown's surface is made of, in sizes of the crown, and of the sprays on them.
constexpr float billow = 0.24f, spray = 0.09f;

// Between random values at whole places: 0 … 1.
float noise(const glm::vec3& p, std::uint64_t seed) {
  const glm::vec3 base = glm::floor(p), share = p - base, ease = share * share * (3.0f - 2.0f * share);
  const auto corner = [&](float x, float y, float z) {
    const auto word = [](float value) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(value)); };
    return random_unit(seed, stream_ragged,
                       hash_combine(hash_combine(word(base.x + x), word(base.y + y)), word(base.z + z)));
  };
  const auto along = [&](float y, float z) { return glm::mix(corner(0, y, z), corner(1, y, z), ease.x); };
  return glm::mix(glm::mix(along(0, 0), along(1, 0), ease.y), glm::mix(along(0, 1), along(1, 1), ease.y), ease.z);
}

}  // namespace

Crowns make_crowns(const CrownHabit& habit, std::span<const glm::vec2> profile, const Surface& mesh) {
  const auto crowns = static_cast<float>(habit.crowns), stems = static_cast<float>(habit.stems);
  const glm::vec3 half = 0.5f * habit.growth * habit.size;
  const float lowest = habit.growth * habit.trunk;
  const float shoots = habit.inner + (1 - habit.inner) * habit.shoots;
  Surface outer, inner;
  Crowns made{Solid({}), Solid({}), {}, 2 * half.y, lowest + (1 + shoots) * half.y, 0, {}, habit.ragged, habit.seed};
  made.across = cube_root(8 * half.x * half.y * half.z);
  for (float i = 0; i < crowns; ++i) {
    const float x = (i - 0.5f * (crowns - 1)) * habit.distance;
    const glm::vec3 middle(x, lowest + half.y, 0);
    made.middles.push_back(middle);
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

// Draws the outer boundary in, here more and there less: what a place would be farther out must still be within it.
bool Foliage::leafy(const glm::vec3& p) const {
  const Crowns& crowns = *crowns_;
  if (!(crowns.ragged > 0)) return true;
  const auto nearest = std::min_element(crowns.middles.begin(), crowns.middles.end(), [&](auto& one, auto& other) {
    return std::fabs(p.x - one.x) < std::fabs(p.x - other.x);
  });
  const auto out = [&](float by) { return crowns.outer.contains(*nearest + (p - *nearest) / (1 - by)); };
  if (out(crowns.ragged)) return true;
  const float lump = noise(p / (billow * crowns.across), crowns.seed);
  const float tuft = noise(p / (spray * crowns.across), crowns.seed + 1);
  return out(crowns.ragged * std::min(0.7f * lump + 0.3f * tuft, 1.0f));
}

float Foliage::density(const glm::vec3& p) const {
  const float share = light_ ? std::min(light_->at(p) / brightest_, 1.0f) : 1;
  const float lit = heed_ == 1 ? share : power(share, heed_);
  return lit * hormone_->left(p);
}

}  // namespace panicle::particles::tree
