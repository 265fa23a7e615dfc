#include "expression/number_text.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

using namespace panicle::expression;

TEST_CASE("decimals become the nearest float") {
  CHECK(number_from("12") == 12.0f);
  CHECK(number_from(".5") == 0.5f);
  CHECK(number_from("1.456") == 1.456f);
  CHECK(number_from("0.1") == 0.1f);
  CHECK(number_from("16777217") == 16777216.0f);
  CHECK(number_from("3.4028235e38") == std::numeric_limits<float>::max());
  CHECK(number_from("1e-45") == std::numeric_limits<float>::denorm_min());
  CHECK(number_from("1e-60") == 0.0f);
  CHECK(number_from("0.000000000000000000000000000000000000000000001e50") == doctest::Approx(1e5f));
  CHECK(number_from("123456789012345678901234567890") == 123456789012345678901234567890.0f);
  CHECK(std::isinf(number_from("1e39")));
  CHECK(std::isinf(number_from("1e999999999999")));
  CHECK(number_from("0e999999999999") == 0.0f);
}

TEST_CASE("numbers are written with the fewest digits that read back") {
  CHECK(number_text(0) == "0");
  CHECK(number_text(1) == "1");
  CHECK(number_text(-2.5f) == "-2.5");
  CHECK(number_text(0.1f) == "0.1");
  CHECK(number_text(1.456f) == "1.456");
  CHECK(number_text(100) == "100");
  CHECK(number_text(99.7f) == "99.7");
  CHECK(number_text(1e-4f) == "0.0001");
  CHECK(number_text(1e20f) == "1e20");
  CHECK(number_text(1.5e-20f) == "1.5e-20");
  CHECK(number_text(16777216) == "16777216");
  CHECK(number_text(std::numeric_limits<float>::infinity()) == "∞");
  CHECK(number_text(-std::numeric_limits<float>::infinity()) == "-∞");
}

TEST_CASE("every finite float survives the way to text and back") {
  std::uint32_t bits = 1;
  for (int i = 0; i < 20000; ++i) {
    bits = bits * 1664525u + 1013904223u;
    float value;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    const std::string text = number_text(std::fabs(value));
    CAPTURE(text);
    CHECK(number_from(text) == std::fabs(value));
  }
}
