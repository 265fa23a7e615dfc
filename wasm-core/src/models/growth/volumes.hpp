// The growth volumes of a footprint, and the divisor functions of a tree, as one plant draws them.
#pragma once

#include <cstdint>
#include <vector>

#include "models/growth/evaluation.hpp"
#include "models/growth/population.hpp"

namespace panicle::growth {

inline constexpr std::uint32_t most_volumes = 64;  // that a footprint has

// False: the evaluation's trouble.
bool draw_volumes(const Rules& rules, std::uint64_t seed, GrowthEvaluation& evaluation, std::vector<GrowthVolume>& volumes);

// Makes the words of a volume known, and those of its environment.
void enter_volume(const GrowthVolume& volume, const Environment& environment, GrowthEvaluation& evaluation);

// What the rules make of a volume's environment. False: the evaluation's trouble.
bool environment_of(const Rules& rules, std::uint64_t seed, const GrowthVolume& volume, std::uint32_t number,
                    GrowthEvaluation& evaluation, Environment& environment);

// Draws among the rules of a tree, works out D and E as far as `steps` can reach, and B and L.
bool draw_functions(const Rules& rules, std::uint64_t seed, std::uint16_t steps, GrowthEvaluation& evaluation);

}  // namespace panicle::growth
