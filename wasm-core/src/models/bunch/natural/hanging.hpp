// How berries hang: the branches of a skeleton, which bend, and the stalks that lead from branches to flowers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/bunch/natural/flowers.hpp"
#include "models/bunch/natural/settling/swelling.hpp"

namespace panicle::bunch {

// A stalk is one internode or several in a chain, drawn by a pedicel's answer, with only flowers at its end. Other
// parts that grow on a stalk, a thorn for instance, move along with it.
struct Hanging {
  std::vector<Branch> branches;          // parents first; millimetres
  std::vector<std::int32_t> branch_of;   // per internode; −1 for stalks and for parts on them
  std::vector<std::int32_t> stalk_from;  // per internode: where its stalk begins; −1 for internodes of no stalk
};

// `bending`, 0 … 1: how readily side branches give way.
Hanging hang(std::span<const Internode> internodes, std::span<const Flower> flowers, float bending);

// The target size of one flower's berry.
struct Fruitlet {
  std::uint32_t flower = 0;
  float half_width = 0, half_length = 0;  // ripe, millimetres
  bool taken = false;                     // removed by hand after it has grown
};

// Hangs berries on the branches. A stalk that grows from no branch gets a point to hang from, added to `branches`.
std::vector<Swelling> hang_berries(std::span<const Fruitlet> fruitlets, std::span<const Internode> internodes,
                                   std::span<const Flower> flowers, const Hanging& hanging,
                                   std::vector<Branch>& branches);

}  // namespace panicle::bunch
