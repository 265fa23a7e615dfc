// The surroundings of the bunch: the piece of cane it grows from and the leaves on it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "models/bunch/foliage/leaf.hpp"
#include "models/bunch/grown.hpp"

namespace panicle::bunch {

struct FoliageOptions {
  std::uint64_t seed = 1;
  std::uint32_t leaves = 0;  // 0 … 5; more than none brings the cane along
  bool cane = false;
  float age = 100;              // the bunch's: leaves open, grow, and turn late
  glm::vec3 foot{0, 0.04f, 0};  // metres: where the peduncle leaves the cane
  float bunch_width = 0;        // metres; leaves are of a size that suits it
  FlatLeaf leaf = {};           // shape of each leaf; no leaves without it
};

// In metres, the bunch hanging down from the origin.
Foliage grow_foliage(const FoliageOptions& options);

}  // namespace panicle::bunch
