// What volumes are to be as wide as so that their skin is as thick as the text says: rounding draws tubes in, by a
// third where they have four sides.
#pragma once

#include <cstdint>
#include <vector>

#include "generalized_map/boundary.hpp"
#include "models/flower/derivation.hpp"

namespace panicle::flower {

// Which volumes are tubes: 1 those more than half of whose sides are free.
std::vector<std::uint8_t> tubes_of(const Derived& derived, const generalized_map::Boundary& boundary);

// What the embedding is to place for a skin that is rounded so often; what is a tube is made wider before.
std::vector<generalized_map::Shape> shapes_to_round(const Derived& derived, const std::vector<std::uint8_t>& is_tube,
                                                    std::uint32_t rounds);

}  // namespace panicle::flower
