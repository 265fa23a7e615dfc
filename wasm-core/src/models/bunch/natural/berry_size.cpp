#include "models/bunch/natural/berry_size.hpp"

#include <algorithm>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

namespace panicle::bunch {
namespace {

constexpr float least_share = 0.55f, max_share = 1.5f;
constexpr float sun_swing = 0.14f;     // between a berry in the shade and one in the sun, at full sunlight
constexpr float hunger_swing = 0.25f;  // between base and tip, without vigour
constexpr std::uint64_t draws = 12;    // number of uniform values, whose sum less 6 is nearly normal with deviation 1

// A nearly normal random value of a flower, of mean 0 and deviation 1: the sum of twelve uniform ones less 6.
float normal_random_value(const Flower& flower, std::uint64_t seed) {
  float noise = -0.5f * draws;
  for (std::uint64_t k = 0; k < draws; ++k)
    noise += random_unit(seed, hash_text("size"), hash_combine(flower.address, k + draws * flower.bunch));
  return noise;
}

}  // namespace

// The width of a flower's berry over the mean one: a random factor, times one for its light and for the sap that comes
// so far down the bunch.
float width_share(const Flower& flower, const Situation& situation, const GrowthConditions& nurture,
                  std::uint64_t seed) {
  const float sun = sun_swing * nurture.sunlight * (situation.lit - 0.5f);
  const float fed = hunger_swing * (1 - nurture.vigour) * (0.5f - situation.along);
  return std::clamp((1 + nurture.spread * normal_random_value(flower, seed)) * (1 + sun + fed), least_share, max_share);
}

// The width of each berry over the mean one, from its `shares` (width_share) and `volumes` (over a full berry). They
// are scaled so that the mean of the first `regular` ones, weighted by volume, is 1.
std::vector<float> balanced_widths(std::span<const float> shares, std::span<const float> volumes, std::size_t regular) {
  float sum = 0, weights = 0;
  for (std::size_t k = 0; k < regular; ++k) {
    sum += shares[k] * volumes[k];
    weights += volumes[k];
  }
  std::vector<float> widths;
  widths.reserve(shares.size());
  for (std::size_t k = 0; k < shares.size(); ++k) widths.push_back(shares[k] * weights / sum * cube_root(volumes[k]));
  return widths;
}

// The width of a flower's ovary, in the unit of a ripe berry's mean width.
float ovary_width(float ripe_width) { return 0.075f * ripe_width; }

}  // namespace panicle::bunch
