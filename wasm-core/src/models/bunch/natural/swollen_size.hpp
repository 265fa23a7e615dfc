// The collision shape of a swelling berry: a ball, swept along a core where it is longer than wide.
#pragma once

#include <algorithm>
#include <cstddef>
#include <glm/vec3.hpp>

#include "models/bunch/natural/settling/swelling.hpp"
#include "spatial/closest_points.hpp"

namespace panicle::bunch {

// Sizes in millimetres.
struct SwollenSize {
  float half_width, half_length;
  float ball;   // radius of the ball
  float core;   // half-length of the sweep along the berry
  float stalk;  // length of the pedicel
};

// `scale`: over the ripe size.
inline SwollenSize swollen_size(const Swelling& berry, float scale) {
  const float a = berry.half_width * scale, b = berry.half_length * scale;
  return {a, b, b >= a ? a : (2 * a + b) / 3, std::max(0.0f, b - a), berry.stalk * stalk_at(scale)};
}

// Upper bound of the pairs that are looked at, per berry.
inline constexpr std::size_t max_pairs = 64;

// Square of a sine below which cores count as parallel.
inline constexpr float parallel_cores = 1e-5f;

// The vector from the nearest point of one core to that of another, whose middle lies `between` from the first's.
inline glm::vec3 between_segments(const glm::vec3& between, const Extent& one, const Extent& other) {
  if (!(one.reach + other.reach > 0)) return between;
  const auto [s, t] = closest_points(between, one, other, parallel_cores);
  return between + other.way * t - one.way * s;
}

}  // namespace panicle::bunch
