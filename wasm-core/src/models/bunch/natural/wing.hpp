// A second bunch beside the first: how it hangs, and the stalk that bends under it.
//
// The stalk leaves the peduncle's node at the requested angle and bends down under its load, the more the heavier that
// is: a small wing stands out, a large one hangs. It is long enough for the second bunch to hang beside the first and
// not in it.
#pragma once

#include <span>
#include <vector>

#include "models/bunch/paper/envelope.hpp"
#include "models/bunch/skeleton.hpp"
#include "models/bunch/stance.hpp"

namespace panicle::bunch {

// The properties of a wing's stalk: millimetres, degrees and grams.
struct WingStalk {
  float fork = 0;        // height of the peduncle's node above p1
  float angle = 0;       // angle at which it leaves
  std::size_t side = 1;  // as in Stance
  float load = 0;        // mass that hangs from it, by now
};

// Height above p1 at which a wing leaves the peduncle, for a width of berries.
float fork_height(float berry_width);

// The stance of `wing` beside `bunch`.
Stance wing_stance(const WingStalk& stalk, const Envelope& bunch, const Envelope& wing);

// The stalk's pieces, the first without a parent; `width` at its foot, `width_end` at the other end.
std::vector<Internode> wing_stalk(const WingStalk& stalk, const Stance& stance, float width, float width_end);

}  // namespace panicle::bunch
