// What neighbours leave a plant of light and room, as a small summary: computed beforehand from crowns as the plan has
// them, so that each plant can be grown by itself.
#pragma once

#include <vector>

#include "models/stand/places.hpp"
#include "models/stand/plan.hpp"

namespace panicle::stand {

inline constexpr std::uint32_t azimuths = 8;  // 0°, 45°, … from +x to +z
inline constexpr std::uint32_t surrounding = 2 * azimuths;
inline constexpr float no_neighbour = 99, least_room = 0.01f;  // metres of free room

// 16 numbers a plant: the horizon's heights in degrees, then free room from the foot in metres. Directions turn with
// the plant: they are those of its own frame, at its own scale. Whole degrees and centimetres: what a plant's own
// link can say, so that it grows by itself as it does here.
std::vector<float> surroundings_of(const Plan& plan, const std::vector<Placement>& plants);

// How much of the sky places on the ground see under the crowns, 255 all: 3 × places in, a byte each out.
std::vector<std::uint8_t> sky_below(const Plan& plan, const std::vector<Placement>& plants,
                                    const std::vector<float>& points);

}  // namespace panicle::stand
