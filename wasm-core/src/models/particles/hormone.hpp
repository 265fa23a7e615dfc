// Apical dominance: the hormone of an axis's tip inhibits side branches near it (Thimann & Skoog 1933), as a density of
// particles.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <span>

#include "foundation/mathematics.hpp"

namespace panicle::particles {

struct Hormone {
  float strength = 0;               // 0 … 1
  float tip = 0;                    // height of the tip, its source
  float reach = 1;                  // distance along the axis over which it falls to 1/e
  float leader = 1;                 // distance from the axis at which the inhibited zone begins
  std::span<const glm::vec3> feet;  // of the axes

  // The share of density left at a place: all on the axis, for the leader goes on.
  float left(const glm::vec3& p) const {
    if (!(strength > 0)) return 1;
    float from_axis = leader;
    for (const glm::vec3& foot : feet)
      from_axis = std::min(from_axis, std::sqrt((p.x - foot.x) * (p.x - foot.x) + (p.z - foot.z) * (p.z - foot.z)));
    return 1 - strength * (from_axis / leader) * exponential(-std::fabs(p.y - tip) / reach);
  }
};

}  // namespace panicle::particles
