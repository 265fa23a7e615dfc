// Narrows forks to the angles of wood: where two particles meet face to face, their trails would be at right angles to
// the way that goes on.
#pragma once

#include "models/particles/guide.hpp"
#include "models/particles/trails.hpp"

namespace panicle::particles {

// Moves each place along the forces of its branches, as strong as a power of the energy that passes: where they
// balance, wood costs least (Murray 1926); the power determines how wide forks are. Places come no nearer to each other
// than `nearest`, and go no farther than `farthest`: else limbs would all leave the trunk at its foot. The target, the
// places that lead straight to it and the ends of twigs stay, and no place goes where it is not open or out of its
// neighbours' sight.
void narrow_forks(Trails& trails, const Guide& guide, float nearest, float farthest);

}  // namespace panicle::particles
