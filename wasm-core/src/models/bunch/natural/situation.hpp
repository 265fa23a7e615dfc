// The place of every flower along the bunch, in its outline and towards the sun; and its turn to set.
//
// Places are those of the bunch hung straight down from the origin: a wing bends down as it ripens, and the flowers
// that set must not depend on that.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/bunch/natural/flowers.hpp"
#include "models/bunch/natural/settling/swelling.hpp"

namespace panicle::bunch {

struct Situation {
  glm::vec3 place{0};   // where its berry would hang if its bunch were upright, millimetres
  float along = 0;      // 0 at the base … 1 at the tip of its bunch
  float lit = 0;        // 0 … 1: how much this side of the outline faces the sun
  float misplaced = 0;  // how far outside the outline, in berry widths; 0 inside
};

// One situation a flower. Millimetres; `size` is a berry's width, `sun` a unit vector towards it.
std::vector<Situation> situate(std::span<const Flower> flowers, std::span<const Internode> internodes,
                               std::span<const BunchEnvelope> bounds, float size, const glm::vec3& sun);

// A unit vector towards a sun at `round` degrees from the front to the right and `height` degrees above the horizon.
glm::vec3 towards_sun(float round, float height);

// A flower's turn to set, 0 … 1: spread evenly over an axis and over each end structure, so that the flowers that set
// are spread evenly. `seed` is the request's.
float turn_of(const Flower& flower, std::uint64_t seed);

}  // namespace panicle::bunch
