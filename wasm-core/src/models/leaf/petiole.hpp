// The petiole: the stalk of a leaf.
#pragma once

#include <vector>

#include "models/leaf/shape/bending.hpp"
#include "stems/segment.hpp"

namespace panicle::particles::leaf {

// Makes a petiole from under the midrib out of the blade and in a gentle bow down, metres: parents first, the blade's
// end first. `length` and `radius` (where it meets the blade) in metres.
std::vector<Segment> make_petiole(const Bending& bending, float length, float radius);

}  // namespace panicle::particles::leaf
