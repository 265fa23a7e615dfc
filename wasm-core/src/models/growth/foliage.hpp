// Leaves where a population has them: on the shoot that came with them, those about to fall, and those that lie on the
// ground.
#pragma once

#include <cstdint>

#include "models/growth/moment.hpp"
#include "plant/plant.hpp"

namespace panicle::growth {

inline constexpr std::uint32_t leaf_tag = 0, falling_tag = 1, fallen_tag = 2, shed_tag = 3, blossom_tag = 4,
                               bunch_tag = 5, organ_tags = 6;

struct LeafHabit {
  float size = 0.14f;      // of a leaf, or a twig of them, metres
  std::uint32_t many = 1;  // leaves for each that is counted
  float stray = 0.5f;      // leaf_poses.hpp
  float fallen = 0;        // share of those about to fall that lie on the ground
  bool needles = false;    // which point away from their twig; others face the light
  float season = 0.4f;     // of the year: 0 late winter, 0.4 summer, 1 winter
  bool evergreen = false;
  std::uint32_t blossoms = 0;                // for each leaf that is counted, in spring
  float blossom_size = 0.03f;                // metres
  std::uint32_t bunches = 0;                 // places for fruit on each branch of a trunk
  float first_bunch = 0.2f, between = 0.1f;  // along that branch: how far up they are, metres
  std::uint64_t seed = 1;
};

// Appends leaves to the organs, then blossoms, then places for bunches: +Y of these is where they hang. Errors: limit.
Diagnostic add_leaves(Plant& plant, const Population& population, const Form& form, const Moment& moment, float time,
                      const LeafHabit& habit, const Limits& limits);

}  // namespace panicle::growth
