// Everything is computed in double from + − × ÷ √ and rounded once to float at the end: a series good to 1e−11 then
// lands within 1 ulp. Those five operations are correctly rounded wherever IEEE 754 holds; the build forbids
// contraction to fused multiply-add (-ffp-contract=off), which would not be.

#include "foundation/mathematics.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include "foundation/bits.hpp"

namespace panicle {
namespace {

constexpr double half_pi = 1.57079632679489661923;
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

// Adding and subtracting 1.5 × 2^52 rounds to the nearest whole number, and leaves that number in the low bits of the
// sum: no conversion to int, which would be undefined for large numbers.
constexpr double rounder = 6755399441055744.0;

struct Nearest {
  double value;
  std::uint64_t low_bits;  // two's complement
};

// The nearest whole number.
Nearest nearest(double x) {
  const double shifted = x + rounder;
  return {shifted - rounder, bit_cast<std::uint64_t>(shifted)};
}

// 2 to the power of a small whole number, whose bits become the exponent of a double.
double two_to_the(std::uint64_t low_bits) { return bit_cast<double>((low_bits + 1023) << 52); }

// Taylor series of the sine about 0; for |x| ≤ π/4 it leaves out less than 7e−12.
double sine_series(double x) {
  const double u = x * x;
  return x + x * u * (-1.0 / 6 + u * (1.0 / 120 + u * (-1.0 / 5040 + u * (1.0 / 362880 - u * (1.0 / 39916800)))));
}

// The same for the cosine; it leaves out less than 4e−13.
double cosine_series(double x) {
  const double u = x * x;
  return 1 + u * (-1.0 / 2 +
                  u * (1.0 / 24 + u * (-1.0 / 720 + u * (1.0 / 40320 + u * (-1.0 / 3628800 + u * (1.0 / 479001600))))));
}

// The exact remainder. Not inlined, because compilers would else compute it for every angle: in wasm it costs more than
// all other steps.
[[gnu::noinline]] double remainder_of(double x, double whole) { return std::fmod(x, whole); }

// Sine and cosine of `quarters` right angles and `rest` radians. Adding 0 turns −0 into 0.
SinCos of_quadrant(std::uint64_t quarters, double rest) {
  const double s = sine_series(rest);
  const double c = cosine_series(rest);
  const bool odd = (quarters & 1) != 0;
  const double sine = odd ? c : s;
  const double cosine = odd ? s : c;
  const bool sine_negative = (quarters & 2) != 0;
  const bool cosine_negative = ((quarters + 1) & 2) != 0;
  return {static_cast<float>(sine_negative ? -sine : sine) + 0.0f,
          static_cast<float>(cosine_negative ? -cosine : cosine) + 0.0f};
}

// Sine and cosine of an angle: the multiple of π/2 is subtracted, then the series are computed.
SinCos sincos_radians(float radians) {
  // π/2 in two parts, the first of 34 bits so that its product with a count of up to 19 bits is exact.
  constexpr double first = 1.5707963267341256;
  constexpr double second = 6.077100506506192e-11;
  double x = radians;
  if (!(std::fabs(x) <= 1e5)) x = remainder_of(x, 4 * half_pi);  // 2π is not exact: accuracy fades with x
  const Nearest quarters = nearest(x * (1 / half_pi));
  return of_quadrant(quarters.low_bits, (x - quarters.value * first) - quarters.value * second);
}

// atan(t) for |t| ≤ √2 − 1, to a relative 8e−13: the polynomial in t² that meets atan(t) / t at Chebyshev's nodes.
double arc_tangent_series(double t) {
  const double u = t * t;
  return t *
         (0.99999999999924476 +
          u * (-0.33333333276922492 +
               u * (0.19999993053555814 +
                    u * (-0.14285386553752139 +
                         u * (0.11103456908947463 +
                              u * (-0.089925529061509115 + u * (0.069741976865952651 - u * 0.037655106012914021)))))));
}

// Angle of (x, y); 0 at the origin.
double angle_of(double y, double x) {
  const double across = std::fabs(x);
  const double up = std::fabs(y);
  const bool steep = up > across;
  const double small = steep ? across : up;
  const double large = steep ? up : across;
  if (large == 0) return 0;
  constexpr double tangent_of_an_eighth = 0.41421356237309504880;  // tan(π/8)
  const bool turned = small > large * tangent_of_an_eighth;        // then measure from the diagonal
  const double t = turned ? (small - large) / (small + large) : small / large;
  double angle = arc_tangent_series(t) + (turned ? half_pi / 2 : 0);
  if (steep) angle = half_pi - angle;
  if (x < 0) angle = 2 * half_pi - angle;
  return y < 0 ? -angle : angle;
}

// e^x for |x| ≤ 700: e^x = 2^n e^r with |r| ≤ ln 2 / 2, where the series leaves out less than 1e−11.
double exponential_of(double x) {
  constexpr double first = 0.6931471804855391;  // ln 2 in two parts, as above
  constexpr double second = 7.440617110012397e-11;
  const Nearest n = nearest(x * 1.44269504088896340736);
  const double r = (x - n.value * first) - n.value * second;
  const double sum =
      1 + r * (1 + r * (1.0 / 2 +
                        r * (1.0 / 6 +
                             r * (1.0 / 24 +
                                  r * (1.0 / 120 +
                                       r * (1.0 / 720 + r * (1.0 / 5040 + r * (1.0 / 40320 + r * (1.0 / 362880)))))))));
  return sum * two_to_the(n.low_bits);
}

// ln x for finite x > 0 that came from a float (never subnormal as a double): x = 2^e m with √½ ≤ m < √2, and
// ln m = 2 artanh((m − 1) / (m + 1)).
double logarithm_of(double x) {
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcdu;
  const std::uint64_t bits = bit_cast<std::uint64_t>(x);
  const std::int64_t exponent = static_cast<std::int64_t>(bits - root_half) >> 52;
  const double m = bit_cast<double>(bits - (static_cast<std::uint64_t>(exponent) << 52));
  const double f = (m - 1) / (m + 1);
  const double u = f * f;
  const double series =
      2 * f * (1 + u * (1.0 / 3 + u * (1.0 / 5 + u * (1.0 / 7 + u * (1.0 / 9 + u * (1.0 / 11 + u * (1.0 / 13)))))));
  return static_cast<double>(exponent) * 0.69314718055994530942 + series;
}

// float(e^x) with the ends of float's range; `x` may be infinite.
float rounded_exponential(double x) {
  if (x > 89) return infinity;
  if (x < -104) return 0;
  return static_cast<float>(exponential_of(x));
}

enum class Parity { fraction, even, odd };

// Whether a number is an even or odd whole number, or has a fraction.
Parity parity_of(float x) {
  if (std::fabs(x) >= 16777216.0f) return Parity::even;  // from 2^24 on every float is an even whole number
  const std::int32_t whole = static_cast<std::int32_t>(x);
  if (static_cast<float>(whole) != x) return Parity::fraction;
  return (whole & 1) != 0 ? Parity::odd : Parity::even;
}

}  // namespace

// Sine and cosine of an angle in degrees; exact at multiples of 90.
SinCos sincos_degrees(float degrees) {
  double x = degrees;
  if (!(std::fabs(x) <= 1e9)) x = remainder_of(x, 360.0);  // exact, like the subtraction below
  const Nearest quarters = nearest(x * (1.0 / 90));
  return of_quadrant(quarters.low_bits, (x - quarters.value * 90) * (half_pi / 90));
}

// The sine, the same on all machines.
float sine(float radians) { return sincos_radians(radians).sine; }

float cosine(float radians) { return sincos_radians(radians).cosine; }

// The angle, 0 … π, of a cosine; arguments beyond ±1 count as ±1.
float arc_cosine(float x) {
  if (x >= 1) return 0;
  if (x <= -1) return static_cast<float>(2 * half_pi);
  const double c = x;
  return static_cast<float>(angle_of(std::sqrt((1 - c) * (1 + c)), c));
}

// The angle, −π/2 … π/2, of a sine; arguments beyond ±1 count as ±1.
float arc_sine(float x) {
  if (x >= 1) return static_cast<float>(half_pi);
  if (x <= -1) return static_cast<float>(-half_pi);
  const double s = x;
  return static_cast<float>(angle_of(s, std::sqrt((1 - s) * (1 + s))));
}

// The angle of the point (x, y), −π … π; 0 at the origin.
float arc_tangent(float y, float x) { return static_cast<float>(angle_of(y, x)); }

// e^x; infinity or 0 beyond the range of floats.
float exponential(float x) { return rounded_exponential(x); }

// The natural logarithm; −∞ at 0, NaN below.
float logarithm(float x) {
  if (x == 0) return -infinity;
  if (!(x > 0)) return not_a_number;
  if (x == infinity) return infinity;
  return static_cast<float>(logarithm_of(x));
}

// The cube root of a positive number; 0 for others.
float cube_root(float x) { return x > 0 ? exponential(logarithm(x) / 3) : 0; }

// base^exponent, as C's pow for infinities, zeros and negative bases, by e^(exponent · ln |base|).
float power(float base, float exponent) {
  if (base == 1 || exponent == 0) return 1;
  if (std::isnan(base) || std::isnan(exponent)) return not_a_number;
  const Parity parity = parity_of(exponent);
  const bool negative = std::signbit(base) && parity == Parity::odd;
  float magnitude;
  if (base == 0) {
    magnitude = exponent > 0 ? 0 : infinity;
  } else if (std::isinf(base)) {
    magnitude = exponent > 0 ? infinity : 0;
  } else if (base < 0 && parity == Parity::fraction) {
    return not_a_number;
  } else {
    magnitude = rounded_exponential(exponent * logarithm_of(std::fabs(base)));
  }
  return negative ? -magnitude : magnitude;
}

}  // namespace panicle
