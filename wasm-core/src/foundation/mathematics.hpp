// Transcendental functions that agree bit for bit on every machine and toolchain: built from + − × ÷ √ alone,
// within 2 ulp of the true float value over the stated range (tests/core/foundation/mathematics_test.cpp).
#pragma once

namespace panicle {

inline constexpr float pi = 3.14159265358979323846f;

struct SinCos {
  float sine, cosine;
};

SinCos sincos_degrees(float degrees);  // exact at multiples of 90°
float sine(float radians);             // |radians| ≤ 1e5
float cosine(float radians);           // |radians| ≤ 1e5
float arc_cosine(float x);             // [−1, 1] → [0, π]; clamps beyond
float arc_sine(float x);               // [−1, 1] → [−π/2, π/2]; clamps beyond
float arc_tangent(float y, float x);   // (−π, π]; 0 at the origin
float exponential(float x);
float logarithm(float x);              // x > 0; −∞ at 0, NaN below
float power(float base, float exponent);  // as C's pow for finite arguments

}  // namespace panicle
