// Points spread evenly by the golden angle: no two of them share a direction from the middle.
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "foundation/mathematics.hpp"

namespace panicle {

inline constexpr float golden_angle = 137.50776f;  // degrees
inline constexpr float golden_ratio = 0.618034f;   // of the smaller part to the larger: (√5 − 1) / 2

// Point i of `count` on the unit disc (Vogel 1979).
inline glm::vec2 golden_disc_point(std::size_t i, std::size_t count) {
  const float radius = std::sqrt((static_cast<float>(i) + 0.5f) / static_cast<float>(count));
  const SinCos turn = sincos_degrees(golden_angle * static_cast<float>(i));
  return {radius * turn.cosine, radius * turn.sine};
}

// Point i of `count` on the unit sphere, from the top downwards: points that are uniform along the axis are uniform on
// the sphere (Archimedes).
inline glm::vec3 golden_sphere_point(std::size_t i, std::size_t count) {
  const float height = 1 - (2 * static_cast<float>(i) + 1) / static_cast<float>(count);
  const float radius = std::sqrt(1 - height * height);
  const SinCos turn = sincos_degrees(golden_angle * static_cast<float>(i));
  return {radius * turn.cosine, height, radius * turn.sine};
}

}  // namespace panicle
