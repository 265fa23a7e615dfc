// How thick lines are whose text sets no width: as thin as a share of their mean length at the tips, and the thicker
// the more tips they bear.
#pragma once

#include <span>

#include "geometry/segment.hpp"

namespace panicle::grammar {

struct Girth {
  float tip = 0.08f;        // width at a tip, over the mean length of all lines
  float thickening = 0.3f;  // the power of the number of tips borne; 0: all are alike, 1/2: Leonardo's rule
};

// Sets the radii of those whose radius is `no_width`'s (sketch.hpp), parents first, in the grammar's unit.
void thicken(std::span<Segment> segments, const Girth& girth);

}  // namespace panicle::grammar
