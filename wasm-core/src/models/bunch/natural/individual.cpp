#include "models/bunch/natural/individual.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

namespace panicle::bunch {
namespace {

// Standard deviations at a variability of 1, over the mean.
constexpr float length_spread = 0.15f;
constexpr float section_spread = 0.32f;  // of the area of its slices
constexpr float together = 0.5f;      // share of that variance that is common with length: long bunches are wide ones
constexpr float side_spread = 0.06f;  // of each half-width by itself
constexpr float shoulder_spread = 0.12f;
constexpr float wing_spread = 0.4f;                          // of its weight
constexpr float gap_height = 0.06f;                          // of each wave
constexpr float gap_length = 7;                              // of a wave, in berry widths
constexpr float least = 0.5f;                                // of any factor
constexpr float raceme_below = pixels_per_axis_segment / 2;  // half-widths with a single pedicel at a node

// Fractional parts of the golden ratio and of square roots of 3, 2, 31, 7 …, times 2^64: multiples of each are spread
// evenly, and those of the first two are uncorrelated already over a few seeds. No two of them and 1 are rationally
// dependent, or one random value would determine another; √5 is left out, for it is in the golden ratio.
constexpr std::uint64_t strides[] = {0x9e3779b97f4a7c15u, 0xbb67ae8584caa73bu, 0x6a09e667f3bcc908u, 0x9159015a3070dd17u,
                                     0xa54ff53a5f1d36f1u, 0x510e527fade682d1u, 0x9b05688c2b3e6c1fu, 0x5be0cd19137e2179u,
                                     0xcbbb9d5dc1059ed8u, 0xae5f9156e7b6d99bu, 0x47b5481dbefa4fa4u};

// The seed's deviation from the mean in the property `which`: 0 … 10, of standard deviation 1, from −2.45 to 2.45, and
// 0 for seed 1. Multiples of an irrational stride, modulo 1, are spread evenly; the square roots make a triangular
// distribution of them.
float seed_deviation(std::uint64_t seed, std::size_t which) {
  const std::uint64_t turns = (seed - 1) * strides[which] + (std::uint64_t{1} << 63);
  const float share = static_cast<float>(turns >> 40) / 16777216.0f;
  constexpr float far = 2.4494897f;
  return share < 0.5f ? far * (std::sqrt(2 * share) - 1) : far * (1 - std::sqrt(2 - 2 * share));
}

// The factor for a property that deviates by `place` standard deviations, each `spread` of the mean.
float factor(float place, float spread) { return std::max(least, 1 + spread * place); }

}  // namespace

// Varies the profile by the seed: its length, its cross-section, and each side by itself. Where berries are counted, a
// longer bunch is narrower, so that its volume is the same.
Profile individual(const Profile& drawn, std::uint64_t seed, float variability, bool counted) {
  Profile profile = drawn;
  const float tall = seed_deviation(seed, 0),
              stout = together * tall + std::sqrt(1 - together * together) * seed_deviation(seed, 1);
  const float longer = factor(tall, variability * length_spread);
  const float wider = std::sqrt(counted ? 1 / longer : factor(stout, variability * section_spread));
  profile.length *= longer;
  for (std::size_t i = 0; i < 4; ++i) {
    SidePoint& side = profile.sides[i];
    const float width = side.width * wider * factor(seed_deviation(seed, 2 + i), variability * side_spread);
    side.width = side.width < raceme_below ? std::min(width, side.width) : std::max(width, raceme_below);
    side.drop *= longer * factor(seed_deviation(seed, 6 + i), variability * shoulder_spread);
  }
  return profile;
}

// The size of the seed's wing (the second bunch) over the requested one; its weight varies, and size goes as the cube
// root of it.
float wing_share(std::uint64_t seed, float variability) {
  return cube_root(factor(seed_deviation(seed, 10), variability * wing_spread));
}

// Four cosine waves through space in random directions, each some berry widths long.
Gaps::Gaps(std::uint64_t seed, float variability, float size) : height_(variability * gap_height) {
  for (std::size_t k = 0; k < waves_.size(); ++k)
    waves_[k] = {random_direction(seed, hash_text("gaps"), k) * (360 / (gap_length * size)),
                 360 * random_unit(seed, hash_text("gap phase"), k)};
}

// The fill at a place, in millimetres, over the mean fill: 1 plus the sum of the waves.
float Gaps::fill_at(const glm::vec3& place) const {
  float fill = 1;
  for (const Wave& wave : waves_) {
    const float degrees = wave.turns.x * place.x + wave.turns.y * place.y + wave.turns.z * place.z + wave.phase;
    fill += height_ * sincos_degrees(degrees).cosine;
  }
  return std::max(least, fill);
}

}  // namespace panicle::bunch
