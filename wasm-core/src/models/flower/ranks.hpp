// Where in its organ a volume is: how far along its axis, and how far beside it.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "models/flower/derivation.hpp"

namespace panicle::flower {

// Of what grows on another volume of its organ, on a side or, 0, at an end.
inline Rank next_rank(Rank before, std::uint16_t side) {
  const bool on_axis = before.beside == 0 && side == 0;
  ++(on_axis ? before.along : before.beside);
  return before;
}

// Ranks as shares of what there is of an organ, 0 … 1, by volume: along its axis by lengths, so that what is drawn
// on it is not drawn out where steps are long; beside it by how many stand there.
std::vector<glm::vec2> places_in_organs(const Derived& derived);

}  // namespace panicle::flower
