// Where in its organ a volume is: how far along its axis, and how far beside it.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "models/flower/derivation.hpp"

namespace panicle::flower {

// The axis of an instance is what has grown end on end from the volume that it begins with; all else lies beside it, as
// far along as what bears it, and one further out than that.
struct Rank {
  std::uint16_t along = 0, beside = 0;
};

struct Ranks {
  std::vector<Rank> of_volume;
  std::vector<Rank> most;  // of each instance
};

Ranks ranks_of(const Derived& derived);

// The same as shares of what there is of an organ, 0 … 1, by volume: along its axis by lengths, so that what is drawn
// on it is not drawn out where steps are long; beside it by how many stand there.
std::vector<glm::vec2> places_in_organs(const Derived& derived);

}  // namespace panicle::flower
