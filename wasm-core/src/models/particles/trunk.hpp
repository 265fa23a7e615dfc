// How particles of a tree find their way: to its trunk, and down that to the ground.
#pragma once

#include <cstdint>

#include "models/particles/guide.hpp"

namespace panicle::particles {

// Each makes for the axis above the target, as much lower than itself as is told: a single point would fork low and
// leave no leader. Limbs cross what is in between, the inner boundary too. Roots do the same with the axis below.
class Trunk final : public Guide {
 public:
  // `slant`: by how much of its distance from the axis a particle aims lower (1 a clear leader, 2 decurrent). `ahead`:
  // how far it looks along the axis that it is on. `way`: −1 where particles come down from above, 1 where they come
  // up.
  Trunk(const glm::vec3& foot, float slant, float ahead, float way = -1)
      : Guide(foot), slant_(slant), ahead_(ahead), way_(way) {}

  glm::vec3 aim(const glm::vec3& p) const override {
    const glm::vec3 foot = target();
    const float from_axis = glm::length(glm::vec3(p.x - foot.x, 0, p.z - foot.z));
    const float drop = glm::max(slant_ * from_axis, ahead_);
    const float left = (p.y - foot.y) * -way_;
    return left <= drop ? foot : glm::vec3(foot.x, p.y + way_ * drop, foot.z);
  }
  float way(const glm::vec3& p) const override {
    const glm::vec3 near = aim(p);
    return glm::distance(p, near) + glm::distance(near, target());
  }

 private:
  float slant_, ahead_, way_;
};

}  // namespace panicle::particles
