#include "models/particles/value_noise.hpp"

#include <algorithm>
#include <glm/common.hpp>

#include "foundation/random.hpp"

namespace panicle::particles {
namespace {

constexpr std::uint64_t stream_ragged = 0x4a99;
// Crowns that are far apart have most of their lattice in the air.
constexpr float max_along = 160;

}  // namespace

// Draws random values in [0, 1) at the corners of a lattice over the box from `low` to `high`, `edge` apart or farther.
ValueNoise::ValueNoise(const glm::vec3& low, const glm::vec3& high, float edge, std::uint64_t seed)
    : edge_(
          std::max({edge, (high.x - low.x) / max_along, (high.y - low.y) / max_along, (high.z - low.z) / max_along})) {
  first_ = glm::ivec3(glm::floor(low / edge_));
  count_ = glm::ivec3(glm::floor(high / edge_)) - first_ + 2;
  values_.clear();
  const auto word = [](std::int32_t value) { return static_cast<std::uint64_t>(std::int64_t{value}); };
  for (std::int32_t z = 0; z < count_.z; ++z)
    for (std::int32_t y = 0; y < count_.y; ++y)
      for (std::int32_t x = 0; x < count_.x; ++x)
        values_.push_back(
            random_unit(seed, stream_ragged,
                        hash_combine(hash_combine(word(first_.x + x), word(first_.y + y)), word(first_.z + z))));
}

// Interpolates the noise at a place between the eight values around it.
float ValueNoise::at(const glm::vec3& p) const {
  const glm::vec3 scaled = p / edge_, base = glm::floor(scaled), share = scaled - base,
                  ease = share * share * (3.0f - 2.0f * share);
  const glm::ivec3 cell = glm::clamp(glm::ivec3(base) - first_, glm::ivec3(0), glm::max(count_ - 2, 0));
  const auto row = [&](int y, int z) {
    const float* two = &values_[static_cast<std::size_t>(((cell.z + z) * count_.y + cell.y + y) * count_.x + cell.x)];
    return glm::mix(two[0], two[1], ease.x);
  };
  return glm::mix(glm::mix(row(0, 0), row(1, 0), ease.y), glm::mix(row(0, 1), row(1, 1), ease.y), ease.z);
}

}  // namespace panicle::particles
