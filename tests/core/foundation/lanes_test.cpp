#include "foundation/lanes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace panicle;

TEST_CASE("exponential of four lanes is within 2 ulp for x ≤ 0, and 1 at 0") {
  double worst = 0;
  for (float x = 0; x > -87; x -= 0.00137f) {
    const Four four = exponential(Four{x, 0, 0.5f * x, -87});
    const double wanted = std::exp(double{x}), ulp = std::nextafter(float(wanted), 2.0f) - float(wanted);
    worst = std::max(worst, std::fabs(static_cast<double>(four[0]) - wanted) / ulp);
    REQUIRE(four[1] == 1);
    REQUIRE(four[2] == exponential(Four{0.5f * x, 0, 0, 0})[0]);
  }
  CHECK(worst < 2);
  const Four far = exponential(Four{-88, -1e30f, -std::numeric_limits<float>::infinity(), -87});
  for (int lane = 0; lane < 4; ++lane) CHECK(far[lane] == far[3]);
  CHECK(far[3] < 2e-38f);
}
