// Axes of a string (Prusinkiewicz and Lindenmayer 1990, section 1.6.1): the main one is of order 0, and what a pair of
// brackets holds is one order higher than what it stands on.
#pragma once

#include <cstdint>
#include <span>

#include "lsystem/lsystem.hpp"
#include "models/grammar/sketch.hpp"

namespace panicle::grammar {

// Of those that have lines.
struct Axes {
  std::uint32_t count = 0, highest = 0;
};

// `lines` in the order of the string.
Axes axes_of(const lsystem::String& string, std::span<const Mark> lines);

}  // namespace panicle::grammar
