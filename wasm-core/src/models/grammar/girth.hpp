// How thick lines are: as wide as the text says; where it says nothing, as thin as a share of their mean length at the
// tips, and the thicker the more tips they bear.
#pragma once

#include <span>

#include "stems/segment.hpp"

namespace panicle::grammar {

struct Girth {
  float tip = 0.08f;        // width at a tip, over the mean length of all lines; more of a plant of very many
  float thickening = 0.3f;  // the power of the number of tips borne; 0: all are alike, 1/2: Leonardo's rule
  float width_factor = 1;           // a factor on widths that the text sets
};

// Sets the radii of those whose width is still `no_width` (sketch.hpp), parents first, in the grammar's unit.
void thicken(std::span<Segment> segments, const Girth& girth);

}  // namespace panicle::grammar
