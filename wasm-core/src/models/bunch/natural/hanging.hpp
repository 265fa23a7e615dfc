// How berries hang: what of a skeleton bends as a branch, and which stalks lead from branches to flowers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/bunch/natural/flowers.hpp"
#include "models/bunch/natural/settling/swelling.hpp"

namespace panicle::bunch {

// A stalk is what a pedicel's answer draws, one internode or several in a chain, as long as nothing but the flowers at
// its end hangs on it. What grows on a stalk besides, a thorn for instance, rides along.
struct Hanging {
  std::vector<Branch> branches;          // parents first; millimetres
  std::vector<std::int32_t> branch_of;   // per internode; −1 for stalks and for what rides on them
  std::vector<std::int32_t> stalk_from;  // per internode: where the stalk begins that it is of; −1 for what is of none
};

// `bending`, 0 … 1: how readily side branches give way.
Hanging hang(std::span<const Internode> internodes, std::span<const Flower> flowers, float bending);

// What one flower's berry is to be.
struct Fruitlet {
  std::uint32_t flower = 0;
  float half_width = 0, half_length = 0;  // ripe, millimetres
  bool taken = false;                     // off by hand once it is grown
};

// Hangs berries on the branches. A stalk that grows from no branch gets a point to hang from, added to `branches`.
std::vector<Swelling> hang_berries(std::span<const Fruitlet> fruitlets, std::span<const Internode> internodes,
                                   std::span<const Flower> flowers, const Hanging& hanging,
                                   std::vector<Branch>& branches);

}  // namespace panicle::bunch
