// Leaves where a population has them: on the shoot that came with them, those about to fall, and those that lie on the
// ground.
#pragma once

#include <cstdint>

#include "models/growth/moment.hpp"
#include "plant/plant.hpp"

namespace panicle::growth {

inline constexpr std::uint32_t leaf_tag = 0, falling_tag = 1, fallen_tag = 2;

struct LeafHabit {
  float size = 0.14f;      // metres
  std::uint32_t many = 1;  // leaves for each that is counted
  float fallen = 0;        // share of those about to fall that lie on the ground
  bool needles = false;    // which point away from their twig; others face the light
  std::uint64_t seed = 1;
};

// Appends them to the organs. Errors: limit.
Diagnostic add_leaves(Plant& plant, const Population& population, const Form& form, const Moment& moment, float time,
                      const LeafHabit& habit, const Limits& limits);

}  // namespace panicle::growth
