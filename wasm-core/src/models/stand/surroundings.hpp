// Light and room that neighbours leave to a plant, as 16 numbers: computed beforehand from the crowns of the plan, so
// that each plant can be grown by itself.
#pragma once

#include <vector>

#include "models/stand/places.hpp"
#include "models/stand/plan.hpp"

namespace panicle::stand {

inline constexpr std::uint32_t azimuths = 8;  // 0°, 45°, … from +x to +z
inline constexpr std::uint32_t surrounding = 2 * azimuths;
inline constexpr float no_neighbour = 99, least_room = 0.01f;  // metres of free room

// 16 numbers a plant: heights of the horizon in degrees, then free room from the foot in metres. Directions and lengths
// are in the plant's own frame, at its own scale. Values are rounded to whole degrees and centimetres, as a link to a
// single plant stores them, so that the plant grows by itself exactly as it does here.
std::vector<float> surroundings_of(const Plan& plan, const std::vector<Placement>& plants);

// Sky visibility of places on the ground under the crowns, 0 … 255: 3 coordinates a place in, a byte a place out.
std::vector<std::uint8_t> sky_below(const Plan& plan, const std::vector<Placement>& plants,
                                    const std::vector<float>& points);

}  // namespace panicle::stand
