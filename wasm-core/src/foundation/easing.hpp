// Two easing polynomials with continuous slope: a step and a hill.
#pragma once

#include <algorithm>

namespace panicle {

// From 0 at 0 to 1 at 1, flat at both ends; not clamped. For a float or lanes of floats.
template <class Number>
constexpr Number smooth(const Number& t) {
  return t * t * (3 - 2 * t);
}

// 0 until `from`, 1 after `to`, an S between.
constexpr float smooth_step(float from, float to, float x) {
  return smooth(std::clamp((x - from) / (to - from), 0.0f, 1.0f));
}

// 1 at 0, 0 from `square` x² = 1 on.
constexpr float hill(float x, float square = 1) {
  const float inside = std::max(0.0f, 1 - x * x * square);
  return inside * inside;
}

// The derivative of `hill`.
constexpr float slope_of_hill(float x) { return -4 * x * std::max(0.0f, 1 - x * x); }

}  // namespace panicle
