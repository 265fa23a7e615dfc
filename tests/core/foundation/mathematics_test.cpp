// Our functions against libm's in double, in units in the last place of the float result.

#include "foundation/mathematics.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "foundation/bits.hpp"

using namespace panicle;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr double right_angle = 1.57079632679489661923;

// Distance from the true value in ulp; 0 where both are the same infinity or both NaN.
double ulps(float got, double want) {
  const float rounded = static_cast<float>(want);
  if (std::isnan(rounded)) return std::isnan(got) ? 0 : 1e9;
  if (std::isinf(rounded)) return got == rounded ? 0 : 1e9;
  const float size = std::fabs(rounded);
  const double ulp = static_cast<double>(std::nextafter(size, infinity)) - size;
  return std::fabs(got - want) / std::min(ulp, 0x1p104);
}

// The worst over finite floats of every sign and exponent, about a hundred thousand each; `stride` is prime.
template <class Error>
double worst(Error error, std::uint64_t stride = 40009) {
  double most = 0;
  for (std::uint64_t bits = 0; bits < 0x100000000u; bits += stride) {
    const float x = bit_cast<float>(static_cast<std::uint32_t>(bits));
    if (std::isfinite(x)) most = std::max(most, error(x, static_cast<std::uint32_t>(bits * 2654435761u)));
  }
  return most;
}

SinCos sincos_reference(float degrees) {
  int quarters = 0;
  const double rest = std::remquo(static_cast<double>(degrees), 90.0, &quarters) * (right_angle / 90);
  const double s = std::sin(rest), c = std::cos(rest);
  const double around[4][2] = {{s, c}, {c, -s}, {-s, -c}, {-c, s}};
  return {static_cast<float>(around[quarters & 3][0]), static_cast<float>(around[quarters & 3][1])};
}

}  // namespace

TEST_CASE("every function is within 1 ulp of libm in double over floats of all sizes") {
  CHECK(worst([](float x, std::uint32_t) { return std::fabs(x) <= 1e5f ? ulps(sine(x), std::sin(double{x})) : 0; }) <
        1);
  CHECK(worst([](float x, std::uint32_t) { return std::fabs(x) <= 1e5f ? ulps(cosine(x), std::cos(double{x})) : 0; }) <
        1);
  CHECK(worst([](float x, std::uint32_t) {
          return std::fabs(x) <= 1 ? ulps(arc_cosine(x), std::acos(double{x})) : 0;
        }) < 1);
  CHECK(worst([](float x, std::uint32_t) { return std::fabs(x) <= 1 ? ulps(arc_sine(x), std::asin(double{x})) : 0; }) <
        1);
  CHECK(worst([](float x, std::uint32_t) { return ulps(exponential(x), std::exp(double{x})); }) < 1);
  CHECK(worst([](float x, std::uint32_t) { return ulps(logarithm(x), std::log(double{x})); }) < 1);
  CHECK(worst([](float x, std::uint32_t other) {
          const float y = bit_cast<float>(other);
          return std::isfinite(y) && (x != 0 || y != 0) ? ulps(arc_tangent(y, x), std::atan2(double{y}, double{x})) : 0;
        }) < 1);
  CHECK(worst([](float x, std::uint32_t other) {
          const float fraction = static_cast<float>(static_cast<std::int32_t>(other)) * 1e-8f;
          const float whole = static_cast<float>(static_cast<std::int32_t>(other) % 40);
          return std::max(ulps(power(x, fraction), std::pow(double{x}, double{fraction})),
                          ulps(power(x, whole), std::pow(double{x}, double{whole})));
        }) < 1);
}

TEST_CASE("sine and cosine of degrees are within 2 ulp and make a unit vector") {
  double error = 0, length = 0;
  const auto look = [&](float degrees) {
    const SinCos got = sincos_degrees(degrees);
    const SinCos want = sincos_reference(degrees);
    error = std::max({error, ulps(got.sine, want.sine), ulps(got.cosine, want.cosine)});
    length = std::max(length, std::fabs(std::hypot(double{got.sine}, double{got.cosine}) - 1));
  };
  for (int i = -200000; i <= 200000; ++i) look(static_cast<float>(i) * 0.0137f);
  worst([&](float x, std::uint32_t) {
    look(x);
    return 0.0;
  });
  CHECK(error <= 1);
  CHECK(length < 1e-7);
}

TEST_CASE("sincos_degrees is exact at multiples of 90 and at 30 and 60") {
  for (int quarter = -4000; quarter <= 4000; ++quarter) {
    const SinCos got = sincos_degrees(static_cast<float>(quarter * 90));
    const int q = ((quarter % 4) + 4) % 4;
    CHECK(got.sine == (q == 1 ? 1.0f : q == 3 ? -1.0f : 0.0f));
    CHECK(got.cosine == (q == 0 ? 1.0f : q == 2 ? -1.0f : 0.0f));
    CHECK_FALSE((std::signbit(got.sine) && got.sine == 0));
    CHECK_FALSE((std::signbit(got.cosine) && got.cosine == 0));
  }
  CHECK(sincos_degrees(30).sine == 0.5f);
  CHECK(sincos_degrees(60).cosine == 0.5f);
  CHECK(sincos_degrees(360e6f).cosine == 1);
}

TEST_CASE("functions are right at the ends of their ranges") {
  CHECK(std::isnan(sincos_degrees(infinity).sine));
  CHECK(std::isnan(sine(not_a_number)));
  CHECK(std::fabs(sine(3e38f)) <= 1);
  CHECK(arc_cosine(1) == 0);
  CHECK(arc_cosine(-1) == pi);
  CHECK(arc_cosine(2) == 0);
  CHECK(arc_cosine(-2) == pi);
  CHECK(arc_sine(2) == pi / 2);
  CHECK(arc_sine(-2) == -pi / 2);
  CHECK(std::isnan(arc_cosine(not_a_number)));
  CHECK(arc_tangent(0, 0) == 0);
  CHECK(arc_tangent(0, -0.0f) == 0);
  CHECK(arc_tangent(0, -1) == pi);
  CHECK(arc_tangent(1, 0) == pi / 2);
  CHECK(arc_tangent(-1, 0) == -pi / 2);
  CHECK(arc_tangent(1e-45f, 3e38f) == 0);
  CHECK(exponential(0) == 1);
  CHECK(exponential(infinity) == infinity);
  CHECK(exponential(-infinity) == 0);
  CHECK(std::isnan(exponential(not_a_number)));
  CHECK(logarithm(1) == 0);
  CHECK(logarithm(0) == -infinity);
  CHECK(logarithm(infinity) == infinity);
  CHECK(std::isnan(logarithm(-1)));
}

TEST_CASE("power agrees with C where C's answer is a matter of definition") {
  const float bases[] = {0.0f, -0.0f, 1,     -1,     2,        -2,        0.5f,        -0.5f,
                         3,    -3,    1e30f, -1e30f, infinity, -infinity, not_a_number};
  const float exponents[] = {0.0f,  -0.0f, 1,     -1,     2,        -2,           3,    -3, 0.5f,
                             -0.5f, 1.5f,  1e30f, -1e30f, 16777218, not_a_number, -2.5f};
  for (const float base : bases) {
    for (const float exponent : exponents) {
      CAPTURE(base);
      CAPTURE(exponent);
      const float want = static_cast<float>(std::pow(double{base}, double{exponent}));
      const float got = power(base, exponent);
      CHECK((std::isnan(want) ? std::isnan(got) : got == want && std::signbit(got) == std::signbit(want)));
    }
  }
  for (int base = -12; base <= 12; ++base) {
    float product = 1;
    for (int exponent = 0; exponent <= 6; ++exponent, product *= static_cast<float>(base)) {
      CHECK(power(static_cast<float>(base), static_cast<float>(exponent)) == product);
    }
  }
}

TEST_CASE("results are frozen: bits of a few values") {
  CHECK(bit_cast<std::uint32_t>(sincos_degrees(15).sine) == 0x3e8483eeu);
  CHECK(bit_cast<std::uint32_t>(sincos_degrees(-123.4f).cosine) == 0xbf0cec4fu);
  CHECK(bit_cast<std::uint32_t>(sine(12345.678f)) == 0xbf344b08u);
  CHECK(bit_cast<std::uint32_t>(cosine(0.1f)) == 0x3f7eb898u);
  CHECK(bit_cast<std::uint32_t>(arc_cosine(0.3f)) == 0x3fa20fafu);
  CHECK(bit_cast<std::uint32_t>(arc_sine(-0.7f)) == 0xbf468073u);
  CHECK(bit_cast<std::uint32_t>(arc_tangent(-2, -3)) == 0xc0236e05u);
  CHECK(bit_cast<std::uint32_t>(exponential(1)) == 0x402df854u);
  CHECK(bit_cast<std::uint32_t>(logarithm(10)) == 0x40135d8eu);
  CHECK(bit_cast<std::uint32_t>(power(1.7f, -3.3f)) == 0x3e31c0eeu);
}

TEST_CASE("cube_root inverts the cube to a few ulp, and is 0 below 0") {
  for (float x = 1e-6f; x < 1e6f; x *= 1.37f)
    CHECK(cube_root(x) == doctest::Approx(std::cbrt(double{x})).epsilon(1e-6));
  CHECK(cube_root(1) == 1);
  CHECK(cube_root(0) == 0);
  CHECK(cube_root(-8) == 0);
}
