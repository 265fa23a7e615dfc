// Axes of a string (Prusinkiewicz and Lindenmayer 1990, section 1.6.1): the main axis is of order 0, and the axis
// within a pair of brackets is one order higher than the axis around it.
#pragma once

#include <cstdint>
#include <span>

#include "lsystem/lsystem.hpp"
#include "models/grammar/sketch.hpp"

namespace panicle::grammar {

// Number and highest order of the axes that have lines.
struct Axes {
  std::uint32_t count = 0, highest = 0;
};

// Finds the axes of a string. `lines`: in the order of the string.
Axes axes_of(const lsystem::String& string, std::span<const Mark> lines);

}  // namespace panicle::grammar
