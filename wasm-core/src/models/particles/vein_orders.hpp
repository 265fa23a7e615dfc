// Trails as veins with orders, as leaf and branch are described: primary, secondary, tertiary.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/particles/trails.hpp"

namespace panicle::particles {

// A trail from where it leaves another to its end: at every fork it goes on as what carries most energy; of equals as
// the first.
struct Vein {
  std::size_t crowd = 0;
  std::vector<std::uint32_t> places;  // from where it leaves to its end; the first is the bearer's, or where it ends
  std::int32_t parent = -1;  // index of an earlier vein; −1: begins at a target, or where a particle is on its way
  std::uint32_t order = 1;
};

// All veins, bearers first. Orders go by rounds. What begins at a target stands for the first; of what stands, all that
// are at least a third as wide as the widest by Leonardo's rule (a ninth of its energy) are of that round's order, and
// what they bear stands for the next, with those left over. So a twig on the midrib is none of its secondaries.
std::vector<Vein> veins_of(std::span<const Trails> crowds);

}  // namespace panicle::particles
