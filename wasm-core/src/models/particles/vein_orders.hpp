// Trails as veins with orders, as leaf and branch are described: primary, secondary, tertiary.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/particles/trails.hpp"

namespace panicle::particles {

// A trail from where it leaves another to its end: at every fork it follows the branch with the most energy; of equals
// the first.
struct Vein {
  std::size_t crowd = 0;
  std::vector<std::uint32_t> places;  // from where it leaves to its end; the first is the parent's, or where it ends
  std::int32_t parent = -1;  // index of an earlier vein; −1: begins at a target, or where a particle is on its way
  std::uint32_t order = 1;
};

// All veins, parents first. Orders go by rounds. The first round has the veins that begin at a target; all veins of a
// round that are at least a third as wide as the widest by Leonardo's rule (a ninth of its energy) get that round's
// order, and their children go to the next round, with those left over. So a twig on the midrib is none of its
// secondaries.
std::vector<Vein> veins_of(std::span<const Trails> crowds);

}  // namespace panicle::particles
