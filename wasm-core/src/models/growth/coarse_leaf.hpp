// A leaf with fewer triangles, for twigs with many leaves.
#pragma once

#include <cstdint>
#include <vector>

#include "foliage/flat_leaf.hpp"

namespace panicle::growth {

// A flat leaf that owns its arrays.
struct CoarseLeaf {
  std::vector<float> points, between, uvs;
  std::vector<std::uint32_t> triangles;

  // The leaf, with the petiole of another one.
  FlatLeaf view(const FlatLeaf& whole) const { return {points, between, uvs, triangles, whole.petiole}; }
};

// The leaf with about `most` triangles: its outline changes as little as possible. The point of the petiole stays.
CoarseLeaf coarse_leaf(const FlatLeaf& leaf, std::uint32_t most);

}  // namespace panicle::growth
