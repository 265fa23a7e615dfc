// Postprocessing of trails for drawing: smoothing, and removal of places that are not needed.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "models/particles/guide.hpp"
#include "models/particles/rib_grid.hpp"
#include "models/particles/trails.hpp"

namespace panicle::particles {

// Moves every place halfway between the next and the mean of those that lead to it, by their energy, by turns outwards
// and inwards along the trails: twigs 2.5 times, places that carry all the energy 17.5 times, or a share of that; half
// a time is half of the way. The target and the ends of twigs stay, and no place goes where it is not open or out of
// its neighbours' sight.
void smooth(Trails& trails, const Guide& guide, float share = 1);

// Moves trails that run along a rib onto it: wholly those on it, less and less up to `reach` from it, and the more
// energy passes the more; ends of twigs stay. Trails that go on along a rib are moved from twice as far, where the way
// is free.
void move_onto_ribs(Trails& trails, const RibGrid& ribs, const Guide& guide, float reach);

// Removes places between forks, starts and ends as long as none of them is farther than `tolerance` from the remaining
// line. Forks, starts and energies stay; with `arrivals` those next to the target too, and so when each came there.
Trails simplified(const Trails& trails, float tolerance, bool arrivals = false);

// Adds places in between, so that no piece that carries an energy from `least` to less than `most` is longer than
// `longest`; pieces that lead straight to the target stay whole. A particle that runs along a piece leaves each added
// place when it comes by.
Trails divided(const Trails& trails, float longest, double least, double most, float stride);

// Moves places back to where they were `before`, where all saw each other, until they do again.
void take_back_hidden(Trails& trails, const std::vector<glm::vec3>& before, const Guide& guide);

}  // namespace panicle::particles
