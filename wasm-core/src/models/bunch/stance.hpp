// The stance of a bunch: where it hangs from, and its lean to a side.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::bunch {

// Lengths are in the unit of the owner.
struct Stance {
  float lean = 0;        // degrees from straight down
  std::size_t side = 1;  // side it leans to: right (p3), left, front, back
  glm::vec3 foot{0};     // where it hangs from
};

// The transforms between the bunch's frame and that of a bunch that hangs straight down from the origin.
class UprightTransform {
 public:
  explicit UprightTransform(const Stance& stance)
      : turn_(sincos_degrees(stance.lean)),
        axis_(stance.side < 2 ? 0 : 2),
        sign_(stance.side % 2 == 0 ? 1.0f : -1.0f),
        foot_(stance.foot) {}

  // A place and a direction in the frame of the bunch hung straight down.
  glm::vec3 place(const glm::vec3& p) const { return way(p - foot_); }
  glm::vec3 way(const glm::vec3& v) const {
    const float across = sign_ * v[axis_];
    return turned(v, across * turn_.cosine + v.y * turn_.sine, v.y * turn_.cosine - across * turn_.sine);
  }
  // A direction back from that frame.
  glm::vec3 way_back(const glm::vec3& v) const {
    const float across = sign_ * v[axis_];
    return turned(v, across * turn_.cosine - v.y * turn_.sine, v.y * turn_.cosine + across * turn_.sine);
  }

 private:
  // The vector with other parts across and up, in the plane in which the bunch leans.
  glm::vec3 turned(glm::vec3 v, float across, float up) const {
    v[axis_] = sign_ * across;
    v.y = up;
    return v;
  }

  SinCos turn_;
  glm::length_t axis_;
  float sign_;
  glm::vec3 foot_;
};

}  // namespace panicle::bunch
