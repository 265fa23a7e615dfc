// How pedicels lean sideways, so that their berries slide apart while they swell and seldom have to press deeply.
//
// Contacts alone cannot do this: stiff ones, or weak pedicels, let berries snap past each other on this side or that,
// and a pixel of the profile then moves a bunch by millimetres. So room is sought before anything swells, where ripe
// berries would hang were each alone: a few rounds of a soft push, smooth in all its inputs, as the gradient of the
// density's kernel in smoothed-particle hydrodynamics (Müller, Charypar and Gross 2003, equation 20).
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/bunch/natural/settling/swelling.hpp"

namespace panicle::bunch {

// The vectors to add to the unit vector along which each ripe berry's pedicel would droop. `turned`: the branches under
// ripe berries. Berries that join late do not lean, and others do not lean away from them.
std::vector<glm::vec3> spread(std::span<const Branch> branches, std::span<const Swelling> berries,
                              std::span<const glm::quat> turned);

}  // namespace panicle::bunch
