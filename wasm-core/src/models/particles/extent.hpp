// The size of a region.
#pragma once

#include "spatial/region.hpp"

namespace panicle::particles {

struct Extent {
  float size = 0;    // area or volume
  float filled = 0;  // the same, weighted by density
};

// Measured by probes that lie evenly in the region's box, of any proportions, so that regions whose boxes are
// stretched copies give stretched results.
Extent extent_of(const Region& region);

}  // namespace panicle::particles
