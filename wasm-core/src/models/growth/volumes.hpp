// Draws the growth volumes of a footprint, and the divisor functions of a tree, for one plant.
#pragma once

#include <cstdint>
#include <vector>

#include "models/growth/evaluation.hpp"
#include "models/growth/population.hpp"

namespace panicle::growth {

inline constexpr std::uint32_t max_volumes = 64;  // greatest number in a footprint

// Draws the volumes of a footprint. False: the evaluation's error.
bool draw_volumes(const Rules& rules, std::uint64_t seed, GrowthEvaluation& evaluation,
                  std::vector<GrowthVolume>& volumes);

// Sets the words of a volume and of its environment.
void enter_volume(const GrowthVolume& volume, const Environment& environment, GrowthEvaluation& evaluation);

// Evaluates a volume's environment by the rules. False: the evaluation's error.
bool environment_of(const Rules& rules, std::uint64_t seed, const GrowthVolume& volume, std::uint32_t number,
                    GrowthEvaluation& evaluation, Environment& environment);

// Draws among the rules of a tree and evaluates D and E as far as `steps` can reach, and B and L.
bool draw_functions(const Rules& rules, std::uint64_t seed, std::uint16_t steps, GrowthEvaluation& evaluation);

}  // namespace panicle::growth
