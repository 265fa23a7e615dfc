// The peduncle of a bunch: part of a shoot, nearly straight, thicker where it leaves the cane and at its node.
#pragma once

#include <cstdint>
#include <vector>

#include "models/bunch/skeleton.hpp"

namespace panicle::bunch {

// Length from the root to the first branch, in the internodes' unit; 0 without any.
float length_to_first_branch(const std::vector<Internode>& internodes);

// The branch that leaves a peduncle at its node.
struct Fork {
  std::int32_t root = -1;  // the internode that grows there; -1: none
  float height = 0;        // metres above p1
};

// Inserts a peduncle before the skeleton, whose roots then grow from its end: its length above p1 is such that it is
// `length` metres from its upper end to where the bunch first branches. `internodes` are in metres, parents first.
// Returns the number of inserted internodes; 0 if the bunch itself is as long before it branches.
std::int32_t add_peduncle(std::vector<Internode>& internodes, float length, std::uint64_t seed, const Fork& fork = {});

}  // namespace panicle::bunch
