// The width of each berry over the mean one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "models/bunch/natural/flowers.hpp"
#include "models/bunch/natural/situation.hpp"

namespace panicle::bunch {

struct GrowthConditions {
  float spread = 0;    // standard deviation of widths over their mean
  float sunlight = 0;  // 0 … 1: how much light counts
  float vigour = 1;    // 0 … 1: how far the sap comes
};

// A berry's width over the mean one: of its random value, its light and the distance that the sap has come.
float width_share(const Flower& flower, const Situation& situation, const GrowthConditions& nurture,
                  std::uint64_t seed);

// Widths of the berries of those flowers that set, scaled so that the mean of the first `regular` ones is 1; the others
// are stand-ins. `volumes`, above 0, are those of the berries over full ones.
std::vector<float> balanced_widths(std::span<const float> shares, std::span<const float> volumes, std::size_t regular);

// Width of a flower's ovary for a mean ripe berry's width, in its unit.
float ovary_width(float ripe_width);

}  // namespace panicle::bunch
