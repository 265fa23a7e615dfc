// Transcendental functions that agree bit for bit on every machine and toolchain: built from + − × ÷ √ alone,
// within 2 ulp of the true value over the stated range (tests/core/foundation/mathematics_test.cpp). None returns −0
// but power; infinite and NaN arguments give C's answer or NaN, never anything undefined.
#pragma once

namespace panicle {

inline constexpr float pi = 3.14159265358979323846f;

struct SinCos {
  float sine, cosine;
};

SinCos sincos_degrees(float degrees);  // any finite angle; exact at multiples of 90°
float sine(float radians);             // |radians| ≤ 1e5; beyond, in [−1, 1] but less and less accurate
float cosine(float radians);           // likewise
float arc_cosine(float x);             // [−1, 1] → [0, π]; clamps beyond
float arc_sine(float x);               // [−1, 1] → [−π/2, π/2]; clamps beyond
float arc_tangent(float y, float x);   // (−π, π], the angle of (x, y) from +x; 0 at the origin
float exponential(float x);
float logarithm(float x);                 // x > 0; −∞ at 0, NaN below
float power(float base, float exponent);  // as C's pow
float cube_root(float x);                 // 0 below 0

}  // namespace panicle
