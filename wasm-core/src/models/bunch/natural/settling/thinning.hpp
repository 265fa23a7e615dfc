// The berries that are lost without room while all swell.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/bunch/natural/swollen_size.hpp"

namespace panicle::bunch {

// Two berries that may press on each other.
struct PressedPair {
  std::uint32_t a, b;
  float deep;  // overlap, millimetres; not above 0 where they are apart
};

// The berries that would have to give up more of their volume to their neighbours than berries can, ascending: only the
// most pressed of each neighbourhood, for the others then have room.
std::vector<std::uint32_t> crowded_out(std::span<const PressedPair> presses, std::span<const SwollenSize> sizes);

}  // namespace panicle::bunch
