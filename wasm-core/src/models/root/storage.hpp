// Storage roots: a main root that swells, as a carrot's or a beet's, without its side roots.
#pragma once

#include <cstddef>
#include <vector>

#include "models/particles/grown.hpp"
#include "stems/segment.hpp"

namespace panicle::particles::root {

struct StorageHabit {
  float radius = 0;  // at the collar, metres
  float reach = 0;   // depth below the collar at which it ends
};

// The radius at a depth below the collar: full at first, then less and less to a point.
float storage_radius(const StorageHabit& habit, float below);

// Thickens the main root of a target: from the collar on along the heaviest, over the storage length. The root is
// straightened to its axis as well, the more the thicker; side roots begin at its moved places.
void swell(std::vector<Segment>& segments, const GrownWood& grown, std::size_t target, const StorageHabit& habit);

}  // namespace panicle::particles::root
