// The changes of a berry with age, as functions of age and of the berry's properties: scrubbing back gives the same
// picture.
#pragma once

#include <cstdint>
#include <vector>

namespace panicle::bunch {

// Ages in percent: 0 the first flowers open, 10 fruit set, 60 colouring begins, 100 ripe, 125 shrivelled.

// Width of a berry over that of the ripe one: a double sigmoid, as berries grow (OENO One 2132), then drying.
float size_at(float age);

// Strength of the relief of a fruit's skin, 0 … 1: ovaries are smooth.
float relief_at(float age);

// Sizes through which berries swell, step by step, up to that of an age.
std::vector<float> sizes_until(float age);

struct BerryCircumstances {
  float along = 0;            // 0 at the base … 1 at the tip of the bunch
  float random_value = 0.5f;  // random, 0 … 1
  float exposure = 0;         // 0 … 1
  float sunlight = 0;         // 0 … 1: weight of the exposure
  float vigour = 1;           // 0 … 1
};

struct Stage {
  float opened = 1, set = 1, turned = 1, shrivel = 0;
};

// Flowers open in the middle, then at the base, then at the tip (Huang et al. 2013, section 3); berries colour one by
// one, those in the sun first.
Stage stage_at(float age, const BerryCircumstances& berry);

// The age at which a flower that does not set falls.
float age_of_fall(float random_value);

// The number of seeds of a berry, 0 … `most`: from `ripening`, its random value for colouring, and to a small part from
// `own`, another random value (0 … 1 each).
float seeds_of(float ripening, float own, float most);

}  // namespace panicle::bunch
