// Vectors and angles in lanes of four: each lane gives the same result as a single computation.
#pragma once

#include <glm/vec3.hpp>

#include "foundation/lanes.hpp"
#include "foundation/mathematics.hpp"

namespace panicle {

// The same value in all four lanes.
inline Four all_of(float value) { return Four{value, value, value, value}; }
// The sum of all four lanes.
inline float sum_of(const Four& four) { return (four[0] + four[1]) + (four[2] + four[3]); }

struct FourVectors {
  Four x, y, z;
};

// The same vector in all four lanes.
inline FourVectors all_of(const glm::vec3& v) { return {all_of(v.x), all_of(v.y), all_of(v.z)}; }

inline FourVectors operator+(const FourVectors& a, const FourVectors& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline FourVectors operator-(const FourVectors& a, const FourVectors& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline FourVectors operator*(const Four& k, const FourVectors& v) { return {k * v.x, k * v.y, k * v.z}; }
// Scalar and vector products, lane by lane.
inline Four dot(const FourVectors& a, const FourVectors& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline FourVectors cross(const FourVectors& a, const FourVectors& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// Vectors of unit length; of no length, not a number.
inline FourVectors unit(const FourVectors& v) { return 1.0f / square_root(dot(v, v)) * v; }
// Selects lanes of `a` where the comparison `which` is true, else of `b`.
template <class Comparison>
FourVectors chosen(const Comparison& which, const FourVectors& a, const FourVectors& b) {
  return {which ? a.x : b.x, which ? a.y : b.y, which ? a.z : b.z};
}

struct FourSinCos {
  Four sine, cosine;
};

// Sine and cosine of angles in turns, from −1e5 to 1e5, within 2e−7 (the polynomials of Moshier's Cephes).
inline FourSinCos sincos_turns(const Four& turns) {
  constexpr float rounder = 12582912;  // as in `exponential`
  const Four shifted = 4 * turns + rounder, r = (4 * turns - (shifted - rounder)) * (pi / 2), u = r * r;
  const Four s = ((-1.9515296e-4f * u + 8.3321609e-3f) * u - 1.6666655e-1f) * u * r + r;
  const Four c = ((2.4433157e-5f * u - 1.3887316e-3f) * u + 4.1666646e-2f) * u * u - 0.5f * u + 1.0f;
  const FourWords quarters = (FourWords)shifted;
  const auto odd = (quarters & 1u) != 0u, below = (quarters & 2u) != 0u, behind = ((quarters + 1u) & 2u) != 0u;
  const Four sine = odd ? c : s, cosine = odd ? s : c;
  return {below ? -sine : sine, behind ? -cosine : cosine};
}

}  // namespace panicle
