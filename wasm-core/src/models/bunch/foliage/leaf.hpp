// A leaf on the cane: the flat leaf of the request, puckered, waved, folded and bent by each leaf's own seed.
#pragma once

#include <cstdint>

#include "foliage/flat_leaf.hpp"
#include "mesh/mesh.hpp"

namespace panicle::bunch {

struct LeafOptions {
  std::uint64_t seed = 1;  // determines side and breadth, waves and folds
  float opening = 1;       // 0: folded along the midrib as it leaves the bud … 1: spread out
  float wilting = 0;       // 0 … 1: how far it hangs and curls, as leaves do before they fall
};

// Makes a leaf, in midribs: the petiole joins at the origin, the tip lies near (0, 1, 0), the upper face looks to +Z
// and is counter-clockwise from there. One surface with an edge, with the flat leaf's vertices in their order.
Mesh make_leaf(const FlatLeaf& flat, const LeafOptions& options);

}  // namespace panicle::bunch
