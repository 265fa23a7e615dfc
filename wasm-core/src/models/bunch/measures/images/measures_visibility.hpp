// The visible berries, and the visible share of the pedicels, by view.
#pragma once

#include "models/bunch/measures/measures_subject.hpp"

namespace panicle::bunch {

// Shares, 0 … 1; meaningless without berries.
struct Visibility {
  float front = 0;     // berries seen from +z
  float side = 0;      // from −x, as the side view shows them
  float mean = 0;      // over the 26 directions from a cube's centre to its faces, edges and corners
  float pedicels = 0;  // length of pedicels seen, over the four horizontal faces
};

// A berry is seen where at least a twentieth of its outline's area lies before all others.
Visibility visibility(const Subject& subject);

}  // namespace panicle::bunch
