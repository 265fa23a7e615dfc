// Measures of branching.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "stems/segment.hpp"

namespace panicle {

struct Branching {
  double length = 0, volume = 0, surface = 0;  // of all segments, as truncated cones
  float low = 0, high = 0;                     // heights
  float width_x = 0, width_z = 0;              // of their box
  float thickest = 0;                          // diameter at the start of the thickest segment without a parent
  std::uint32_t tips = 0, forks = 0;
  // Strahler (1957): tips are 1; where two or more of the highest order meet it is one more. A branch of an order is a
  // run of segments of that order.
  std::uint32_t order = 0;
  std::array<std::uint32_t, 32> of_order{};  // branches, by order − 1
  float bifurcation = 0;                     // geometric mean of of_order[k] / of_order[k + 1]; NaN for a single order
  float fork_angle = 0;                      // degrees, mean over forks, between their two thickest; NaN without forks
};

// Measures segments with parents first. No value is NaN but those documented so.
Branching branching_of(std::span<const Segment> segments);

}  // namespace panicle
