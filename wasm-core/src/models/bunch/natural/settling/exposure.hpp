// The share of the sun's light that reaches each berry past the others.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/bunch/berry/berry_body.hpp"

namespace panicle::bunch {

// One share a berry, 0 … 1: the part of the disc facing the sun that no other berry shades. Berries count as
// ellipsoids; a shadow's edge is a penumbra of a quarter of the berry that casts it, so that the share changes smoothly
// as berries move. `towards_sun` may have any length but 0; all lengths in one unit. Cost: berries × those in front of
// them.
std::vector<float> sun_exposure(std::span<const BerryBody> berries, glm::vec3 towards_sun);

}  // namespace panicle::bunch
