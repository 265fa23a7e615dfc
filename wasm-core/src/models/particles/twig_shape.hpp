// The shape that branches take on after they have grown: twigs that hang, branches that wander.
#pragma once

#include <cstdint>

#include "models/particles/guide.hpp"
#include "models/particles/trails.hpp"
#include "spatial/region.hpp"

namespace panicle::particles {

struct TwigHabit {
  float weep = 0;        // how far twigs turn towards straight down, 0 … 1
  float weep_tips = 20;  // what bears so many tips does not turn
  float crook = 0;       // how far branches stray from their way, in spacings
  float crook_tips = 1;  // what bears fewer tips goes straight from place to place

  bool shapes() const { return weep > 0 || crook > 0; }
};

// What bears fewer tips than is told turns down, the more the fewer and the farther from where that begins: over `arc`.
// Tips sink with what bears them where there is `room` for them, and the fewer of its tips have room the less a twig
// turns; nothing hangs out of `outer` that was in it. What has no room still leads on to where it was.
void hang(Trails& trails, const Guide& guide, const Region& outer, const Region& room, const TwigHabit& habit,
          float arc);

// Draws places aside by noise, which all that is near is drawn by alike: `by` at most, changing over about `over`; less
// where more of all energy passes. Tips and what leads straight to the target stay, and nothing leaves `outer`.
void wander(Trails& trails, const Guide& guide, const Region& outer, float by, float over, std::uint64_t seed);

}  // namespace panicle::particles
