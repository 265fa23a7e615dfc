// Vectors of four floats or words, which compilers translate to instructions of SSE, NEON or WebAssembly SIMD. Each
// lane rounds as a single float does, so results are the same everywhere.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace panicle {

typedef float Four __attribute__((vector_size(16)));
typedef std::uint32_t FourWords __attribute__((vector_size(16)));
typedef std::int32_t FourIntegers __attribute__((vector_size(16)));

// Reads four values that lie one after another, at any address.
inline Four load(const float* values) {
  Four four;
  std::memcpy(&four, values, sizeof four);
  return four;
}

inline FourWords load(const std::uint32_t* values) {
  FourWords four;
  std::memcpy(&four, values, sizeof four);
  return four;
}

// Writes four values one after another.
inline void store(float* values, const Four& four) { std::memcpy(values, &four, sizeof four); }
inline void store(std::uint32_t* values, const FourWords& four) { std::memcpy(values, &four, sizeof four); }

// The one operation that needs intrinsics.
inline Four square_root(const Four& v) {
#if defined(__wasm_simd128__)
  return (Four)wasm_f32x4_sqrt((v128_t)v);
#elif defined(__SSE2__)
  return _mm_sqrt_ps(v);
#else
  return Four{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
#endif
}

// e to the power of x ≤ 0, within 2 ulp (the polynomial of Moshier's Cephes); below −87 as at −87.
inline Four exponential(Four x) {
  constexpr float least = -87, per_doubling = 1.44269504f, doubling = 0.693359375f, rest = 2.12194440e-4f;
  constexpr float rounder =
      12582912;  // 1.5 · 2²³: added to a number, rounds it; the low bits of the sum are the whole number
  x = x < least ? Four{least, least, least, least} : x;
  const Four shifted = x * per_doubling + rounder, whole = shifted - rounder;
  const Four r = (x - whole * doubling) + whole * rest;
  const Four series =
      ((((1.9875691e-4f * r + 1.3981999e-3f) * r + 8.3334519e-3f) * r + 4.1665796e-2f) * r + 1.6666665e-1f) * r + 0.5f;
  const Four power = series * (r * r) + r + 1.0f;
  return (Four)((FourWords)power + ((FourWords)shifted << 23));
}

// Which lanes of a comparison are true: the first lane's is the lowest bit.
template <class Comparison>
std::uint32_t true_lanes(const Comparison& four) {
#if defined(__wasm_simd128__)
  return wasm_i32x4_bitmask((v128_t)four);
#elif defined(__SSE2__)
  return static_cast<std::uint32_t>(_mm_movemask_ps((__m128)four));
#else
  return (four[0] & 1u) | (four[1] & 2u) | (four[2] & 4u) | (four[3] & 8u);
#endif
}

// Are all lanes of a comparison true (−1, not 0)?
template <class Comparison>
bool all(const Comparison& four) {
  std::int64_t two[2];
  static_assert(sizeof two == sizeof four);
  std::memcpy(two, &four, sizeof two);
  return (two[0] & two[1]) == -1;
}

}  // namespace panicle
