// What a fruit's surface has beyond its form: scar, seat and relief, as seen from the centre.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "geometry/berry_body.hpp"

namespace panicle {

// How far the surface lies in a direction (unit vector, tip +Y) over how far the free form does.
float skin_height(Fruit fruit, const glm::vec3& direction);

// The most that skin_height gives.
float highest_skin(Fruit fruit);

// Segments round the widest ring that show the relief, for `segments` of a smooth berry of ours.
std::uint32_t skin_meridians(Fruit fruit, std::uint32_t segments);

}  // namespace panicle
