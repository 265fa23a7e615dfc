// How large a region is.
#pragma once

#include "spatial/region.hpp"

namespace panicle::particles {

struct Extent {
  float size = 0;    // area or volume
  float filled = 0;  // that where each place counts by its density
};

// Measured by probes that lie evenly in the region's box, of any proportions, so that regions whose boxes are
// stretched copies give stretched results.
Extent extent_of(const Region& region);

}  // namespace panicle::particles
