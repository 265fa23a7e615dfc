// Trails at a moment of their growing.
#pragma once

#include "models/particles/trails.hpp"

namespace panicle::particles {

// The trails as they stood at a moment, counted in steps, with the energy that had passed by then. Who was on the way from a place
// to the next is between them; `stride` is how far a particle comes in a step at most, which tells when it came to
// where others had been before it. Places that
// nothing leads on from have `next` −1: particles on their way or not yet gone; place 0 is the target. At the last step and
// later, all trails.
Trails at_moment(const Trails& trails, float moment, float stride);

}  // namespace panicle::particles
