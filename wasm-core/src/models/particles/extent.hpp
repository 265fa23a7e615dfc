// How large a region is.
#pragma once

#include "spatial/region.hpp"

namespace panicle::particles {

struct Extent {
  float size = 0;    // area or volume
  float filled = 0;  // that where each place counts by its density
};

// By probes that lie evenly in the region's box however long and thin that is, so that all are told whose box is
// another's stretched.
Extent extent_of(const Region& region);

}  // namespace panicle::particles
