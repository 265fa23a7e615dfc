#include "models/bunch/natural/ripening.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/easing.hpp"

namespace panicle::bunch {
namespace {

constexpr float flower_size = 0.08f;
constexpr int steps_to_ripe = 36;
constexpr int steps_of_drying = 5;

}  // namespace

// The width of a berry over that of the ripe one at an age in percent: two S-shaped phases of growth, then 20 % of
// drying.
float size_at(float age) {
  const float fresh = flower_size + 0.56f * smooth_step(8, 48, age) + (0.44f - flower_size) * smooth_step(58, 100, age);
  return fresh * (1 - 0.2f * smooth_step(102, 125, age));
}

// The strength of the relief of a fruit's skin, 0 … 1, at an age in percent.
float relief_at(float age) { return smooth_step(8, 24, age); }

// The sizes, over the ripe one, through which berries swell step by step up to `age`: growth in equal steps, then
// drying to the size at that age.
std::vector<float> sizes_until(float age) {
  std::vector<float> sizes;
  const float last = size_at(age), largest = age > 100 ? 1 : last;
  for (int k = 0; k <= steps_to_ripe; ++k) {
    const float size = flower_size + (1 - flower_size) * static_cast<float>(k) / steps_to_ripe;
    if (size < largest) sizes.push_back(size);
  }
  sizes.push_back(largest);
  if (age > 100)
    for (int k = 1; k <= steps_of_drying; ++k)
      sizes.push_back(1 + (last - 1) * static_cast<float>(k) / steps_of_drying);
  return sizes;
}

// How far a berry's flower has opened and set, and the berry has coloured and shrivelled (each 0 … 1) at `age`, in
// percent. Flowers open in the middle of the bunch first, then at its base, then at its tip.
Stage stage_at(float age, const BerryCircumstances& berry) {
  const float middle = 0.45f;
  const float order =
      berry.along < middle ? 0.6f * (middle - berry.along) / middle : (berry.along - middle) / (1 - middle);
  const float opens = 4.5f * order + 1.5f * berry.random_value - 0.8f;
  const float turns =
      60 + 20 * berry.random_value + 8 * (berry.sunlight * (0.5f - berry.exposure)) + 4 * (1 - berry.vigour);
  Stage stage;
  stage.opened = smooth_step(opens, opens + 1, age);
  stage.set = smooth_step(7.5f + 0.4f * opens, 10 + 0.4f * opens, age);
  stage.turned = smooth_step(turns, turns + 14, age);
  stage.shrivel = std::min(1.0f, smooth_step(102, 125, age) * (0.6f + 0.7f * berry.random_value));
  return stage;
}

// The number of seeds of a berry, 0 … `most`, from two random values, 0 … 1; the one for ripening counts more.
float seeds_of(float ripening, float own, float most) {
  constexpr float short_of_one_more = 0.99f, least = 0.15f;
  return std::floor((most + short_of_one_more) * std::clamp(least + 0.5f * ripening + 0.3f * own, 0.0f, 1.0f));
}

// The age, in percent, at which a flower that does not set falls.
float age_of_fall(float random_value) { return 8.5f + 3 * random_value; }

}  // namespace panicle::bunch
