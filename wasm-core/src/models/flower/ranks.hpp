// Positions of volumes in their organs: along the axis, and beside it.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "models/flower/derivation.hpp"

namespace panicle::flower {

// The rank of a volume that grows on another of its organ: on a side, or with 0 on an end.
inline Rank next_rank(Rank before, std::uint16_t side) {
  const bool on_axis = before.beside == 0 && side == 0;
  ++(on_axis ? before.along : before.beside);
  return before;
}

// Ranks as shares of the organ, 0 … 1, by volume: along the axis by length, so that paint is not stretched where
// volumes are long; beside it by number.
std::vector<glm::vec2> organ_coordinates(const Derived& derived);

}  // namespace panicle::flower
