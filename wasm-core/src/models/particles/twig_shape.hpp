// The shape of branches after growth: hanging twigs, wandering branches.
#pragma once

#include <cstdint>

#include "models/particles/guide.hpp"
#include "models/particles/trails.hpp"
#include "spatial/region.hpp"

namespace panicle::particles {

struct TwigHabit {
  float weep = 0;        // how far twigs turn towards straight down, 0 … 1
  float weep_tips = 20;  // twigs with this many tips do not turn
  float crook = 0;       // how far branches stray from their way, in spacings
  float crook_tips = 1;  // twigs with fewer tips go straight from place to place

  // Whether it changes any twig.
  bool shapes() const { return weep > 0 || crook > 0; }
};

// Turns twigs with fewer tips than given down, the more the fewer, and the more the farther from where the twig begins:
// over `arc`. Tips sink with their twigs where there is `room` for them, and the fewer of its tips have room the less a
// twig turns; nothing that was in `outer` leaves it. Trails without room still lead to where they led before.
void hang_twigs(Trails& trails, const Guide& guide, const Region& outer, const Region& room, const TwigHabit& habit,
                float arc);

// Moves places sideways by noise, near places alike: `by` at most, changing over about `over`; less where more of all
// energy passes. Tips and places that lead straight to the target stay, and no place leaves `outer`.
void wander_branches(Trails& trails, const Guide& guide, const Region& outer, float by, float over, std::uint64_t seed);

}  // namespace panicle::particles
