// The places of a tree's leaves: where particles started, and back from there along the last shoot.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "models/particles/trails.hpp"
#include "plant/plant.hpp"

namespace panicle::particles::tree {

struct LeafHabit {
  std::uint32_t count = 2;  // at each place: two opposite each other, more one behind the other
  float size = 0.1f;        // metres
  float attached = 1;       // the share that has not fallen
  bool needles = false;     // whether they point away from their twig; others face the light
  glm::vec3 light{0, 1, 0};
  float unfolded = 1;  // progress of unfolding of all together, the lowest first, 0 … 1
  std::uint64_t seed = 1;
};

// Appends the leaves of one target's trails: `numbers` has the segment of each place.
void add_leaves(Plant& plant, const Trails& trails, std::span<const std::int32_t> numbers, const LeafHabit& habit,
                std::uint32_t tag);

}  // namespace panicle::particles::tree
