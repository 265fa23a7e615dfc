// Leaves of a population: on the shoots that they came with, about to fall, and on the ground.
#pragma once

#include <cstdint>

#include "models/growth/moment.hpp"
#include "models/growth/twig_shapes.hpp"
#include "plant/plant.hpp"

namespace panicle::growth {

inline constexpr std::uint32_t leaf_tag = 0, falling_tag = 1, fallen_tag = 2, shed_tag = 3, blossom_tag = 4,
                               bunch_tag = 5, twig_tag = 6, organ_tags = 7;

struct LeafHabit {
  float size = 0.14f;      // length of a leaf, or of a twig of leaves, metres
  std::uint32_t many = 1;  // leaves for each counted leaf
  float stray = 0.5f;      // leaf_poses.hpp
  float fallen = 0;        // share of leaves about to fall that are on the ground
  bool needles = false;    // needles point away from their twig; other leaves face the light
  float season = 0.4f;     // of the year: 0 late winter, 0.4 summer, 1 winter
  bool evergreen = false;
  std::uint32_t blossoms = 0;                // for each counted leaf, in spring
  float blossom_size = 0.03f;                // metres
  std::uint32_t bunches = 0;                 // places for fruit on each branch of a trunk
  float first_bunch = 0.2f, between = 0.1f;  // height of the first along that branch, and distance to the next, metres
  TwigHabit twigs;           // where it has shapes, a leaf organ has all leaves of a twig, which is an organ of its own
  float twig_length = 0.4f;  // of the longest, metres
  float lift = 0.2f;         // how far twigs rise; below 0 they hang, −1: straight down
  std::uint64_t seed = 1;
};

// The size of leaves of each shape of twig over their full size, by the season: the buds of one shape open together.
std::vector<float> unfolded_by_shape(const LeafHabit& habit);

// Appends leaves to the organs, then blossoms, then places for bunches, which hang along their +Y. Of twigs and their
// leaves, `mesh` is the number of their shape. Errors: limit.
Diagnostic add_leaves(Plant& plant, const Population& population, const Form& form, const Moment& moment, float time,
                      const LeafHabit& habit, const Limits& limits);

}  // namespace panicle::growth
