// Thickness of lines: as wide as the grammar sets; else, at the tips, a share of the mean length of lines, and thicker
// with the number of tips above.
#pragma once

#include <span>

#include "stems/segment.hpp"

namespace panicle::grammar {

struct Girth {
  float tip = 0.08f;        // width at a tip, over the mean length of all lines; more for a plant of very many
  float thickening = 0.3f;  // exponent of the number of tips above; 0: all are alike, 1/2: Leonardo's rule
  float width_factor = 1;   // factor on widths that the grammar sets
};

// Sets the radii of segments whose width is still `no_width` (sketch.hpp), parents first, in the grammar's unit.
void thicken(std::span<Segment> segments, const Girth& girth);

}  // namespace panicle::grammar
