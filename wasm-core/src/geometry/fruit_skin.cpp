#include "geometry/fruit_skin.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/mathematics.hpp"

namespace panicle {
namespace {

// A smooth hill of height 1 and half-width 1.
float hill(float x) {
  const float inside = std::max(0.0f, 1 - x * x);
  return inside * inside;
}

// Angles from the tip and from the seat, radians.
float scar(float from_tip) {
  const float dimple = -0.040f * hill(from_tip / 0.34f);
  const float style = 0.026f * hill(from_tip / 0.11f);
  return dimple + style;
}

// A shallow hollow for the pedicel within the collar that it leaves.
float seat(float from_seat) {
  const float flat = -0.022f * hill(from_seat / 0.70f);
  const float collar = 0.014f * hill((from_seat - 0.19f) / 0.11f);
  return flat + collar;
}

}  // namespace

float skin_height(Fruit, const glm::vec3& direction) {
  const float across = std::sqrt(direction.x * direction.x + direction.z * direction.z);
  const float from_tip = arc_tangent(across, direction.y);
  return 1 + scar(from_tip) + seat(pi - from_tip);
}

float highest_skin(Fruit) { return 1; }

std::uint32_t skin_meridians(Fruit, std::uint32_t segments) { return segments * 5 / 4; }

}  // namespace panicle
