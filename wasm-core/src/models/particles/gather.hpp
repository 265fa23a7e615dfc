// Unites trails that run down the same axis: particles that follow each other there never meet, and a tree would have
// several trunks in one.
#pragma once

#include "models/particles/axis.hpp"
#include "models/particles/guide.hpp"
#include "models/particles/trails.hpp"

namespace panicle::particles {

// Gathers the parts of trails that are closer than `reach` to the axis through the target into one line of places, from
// the place farthest up or down to the target. Starts stay ends, energies arrive as before, and a place is as old as
// the first particle that comes by, at `stride` a step; the target is as old as the last arrival at the line. Places
// that no particle passes any more are left out. Where an obstacle is on the axis, the part beyond it is a line of its
// own, which goes round as its particles went.
Trails gathered(const Trails& trails, const Axis& axis, const Guide& guide, float reach, float stride);

}  // namespace panicle::particles
