#include "models/bunch/natural/berry_size.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "foundation/random.hpp"
#include "models/bunch/natural/stages.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

TEST_CASE("widths vary by the requested spread, about 1") {
  double sum = 0, square = 0;
  const int flowers = 4000;
  for (std::uint32_t i = 0; i < flowers; ++i) {
    Flower flower = flower_on(0, {0, -1, 0}, i);
    flower.address = hash_combine(3, i);
    const double share = width_share(flower, {{}, 0.5f, 0.5f, 0}, {0.1f, 0.4f, 1}, 1);
    sum += share;
    square += share * share;
  }
  const double mean = sum / flowers;
  CHECK(mean == doctest::Approx(1).epsilon(0.01));
  CHECK(std::sqrt(square / flowers - mean * mean) == doctest::Approx(0.1).epsilon(0.05));
}

TEST_CASE("light widens by up to seven hundredths either way, hunger narrows the tip by an eighth") {
  const Flower flower = flower_on(0, {0, -1, 0});
  const auto share = [&](float along, float lit, const GrowthConditions& nurture) {
    return width_share(flower, {{}, along, lit, 0}, nurture, 1);
  };
  CHECK(share(0.5f, 1, {0, 1, 1}) == doctest::Approx(1.07));
  CHECK(share(0.5f, 0, {0, 1, 1}) == doctest::Approx(0.93));
  CHECK(share(1, 0.5f, {0, 0, 0}) == doctest::Approx(0.875));
  CHECK(share(0, 0.5f, {0, 0, 0}) == doctest::Approx(1.125));
  CHECK(share(1, 0, {0, 0, 1}) == doctest::Approx(1));
}

TEST_CASE("the mean width is exact, and a berry that only just sets is small") {
  const std::vector<float> shares{1.2f, 1.3f, 1.1f, 1.2f}, volumes{1, 1, 0.125f, 1};
  const std::vector<float> widths = balanced_widths(shares, volumes, 3);
  CHECK((widths[0] + widths[1] + 0.125f * widths[2] / 0.5f) / 2.125f == doctest::Approx(1));
  CHECK(widths[2] < 0.51f);
  CHECK(widths[1] / widths[0] == doctest::Approx(1.3 / 1.2));
  CHECK(widths[3] == widths[0]);  // it stands in, and has no part in the mean
}
