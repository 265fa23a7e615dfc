// What hangs around the bunch: the piece of cane it grows from and the leaves on it.
#pragma once

#include <cstdint>

#include "models/bunch/foliage/leaf.hpp"
#include "models/bunch/grown.hpp"

namespace panicle::bunch {

struct FoliageOptions {
  std::uint64_t seed = 1;
  std::uint32_t leaves = 0;  // 0 … 5; more than none brings the cane along
  bool cane = false;
  float age = 100;            // the bunch's: leaves open, grow, and turn late
  float peduncle_radius = 0;  // metres, where the bunch begins (p1, the origin); the cane passes above it
  float bunch_width = 0;      // metres; leaves are of a size that suits it
  FlatLeaf leaf = {};         // what each is made from; there are none without it
};

// In metres, the bunch hanging down from the origin. Includes the peduncle that joins cane and rachis.
Foliage grow_foliage(const FoliageOptions& options);

}  // namespace panicle::bunch
