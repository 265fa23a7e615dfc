// Variation between seeds: changes the profile that the handles draw, and the fill.
//
// Every factor depends on the seed alone, not on the handles, so that dragging moves a bunch and never redraws it; over
// seeds each has the mean 1. Seeds counted up cover the spread evenly, and seed 1 is in the middle of it: its outline
// is the handles'. The spread of each factor is in docs/natural.md.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "models/bunch/plan.hpp"

namespace panicle::bunch {

// Varies the profile by the seed. `variability`: 0 leaves the profile as it is, 1 is the spread of a variety. Where
// berries are `counted`, a longer bunch is a narrower one, so that they have the same room.
Profile individual(const Profile& drawn, std::uint64_t seed, float variability, bool counted);

// The size of the seed's wing over the requested one; in weight its mean is 1.
float wing_share(std::uint64_t seed, float variability);

// Variation of the fill over space: long waves of denser and looser parts.
class Gaps {
 public:
  // `size`: a berry's width, millimetres.
  Gaps(std::uint64_t seed, float variability, float size);

  // Over the mean fill; always above 0.
  float fill_at(const glm::vec3& place) const;

 private:
  struct Wave {
    glm::vec3 turns{0};  // degrees to a millimetre
    float phase = 0;
  };
  std::array<Wave, 4> waves_;
  float height_ = 0;
};

}  // namespace panicle::bunch
