// Widens volumes before rounding, so that their skin is as thick as the text sets: rounding shrinks tubes, by a third
// where they have four sides.
#pragma once

#include <cstdint>
#include <vector>

#include "generalized_map/boundary.hpp"
#include "models/flower/derivation.hpp"

namespace panicle::flower {

// Marks tubes with 1: volumes more than half of whose sides are free.
std::vector<std::uint8_t> tubes_of(const Derived& derived, const generalized_map::Boundary& boundary);

// Shapes for the embedding of a skin with this number of rounds; tubes are wider.
std::vector<generalized_map::Shape> shapes_to_round(const Derived& derived, const std::vector<std::uint8_t>& is_tube,
                                                    std::uint32_t rounds);

}  // namespace panicle::flower
