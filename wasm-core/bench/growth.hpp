// A tree by divisor functions, up to one of its stages: the cost of a stage is its difference to the one before.
#pragma once

#include <cstdint>

namespace panicle::bench {

enum class Stage : std::uint32_t { text, population, form, moment, leaves, levels };

// The tree of Table 1's σ1 after so many steps, from reading its text to the stage. Work: its branches, or of `text`
// its rules; negative where it failed.
double run_growth(Stage stage, std::uint32_t steps, std::uint32_t seed);

}  // namespace panicle::bench
