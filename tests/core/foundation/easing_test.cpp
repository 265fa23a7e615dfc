#include "foundation/easing.hpp"

#include <doctest/doctest.h>

#include "foundation/lanes.hpp"

using namespace panicle;

TEST_CASE("a step is 0 before, 1 after, half in the middle, and rises between") {
  CHECK(smooth_step(8, 48, 7) == 0);
  CHECK(smooth_step(8, 48, 8) == 0);
  CHECK(smooth_step(8, 48, 28) == 0.5f);
  CHECK(smooth_step(8, 48, 48) == 1);
  CHECK(smooth_step(8, 48, 1e9f) == 1);
  for (float x = 8; x < 47; ++x) CHECK(smooth_step(8, 48, x + 1) > smooth_step(8, 48, x));
  CHECK(smooth(0.25f) == 0.15625f);
}

TEST_CASE("smooth() of four lanes equals four single calls") {
  const Four four = smooth(Four{0, 0.125f, 0.7f, 1});
  CHECK(four[0] == smooth(0.0f));
  CHECK(four[1] == smooth(0.125f));
  CHECK(four[2] == smooth(0.7f));
  CHECK(four[3] == smooth(1.0f));
}

TEST_CASE("a hill is 1 at its middle, ends smoothly, and slope_of_hill is its derivative") {
  CHECK(hill(0) == 1);
  CHECK(hill(0.5f) == 0.5625f);
  CHECK(hill(-0.5f) == 0.5625f);
  CHECK(hill(1) == 0);
  CHECK(hill(3) == 0);
  CHECK(hill(1, 0.25f) == 0.5625f);
  CHECK(hill(2, 0.25f) == 0);
  for (float x = -1.25f; x <= 1.25f; x += 0.125f) {
    constexpr float step = 1.0f / 256;
    CHECK(slope_of_hill(x) == doctest::Approx((hill(x + step) - hill(x - step)) / (2 * step)).epsilon(0.02));
  }
}
