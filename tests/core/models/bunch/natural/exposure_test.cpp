#include "models/bunch/natural/settling/exposure.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/random.hpp"

using namespace panicle;
using namespace panicle::bunch;

namespace {

constexpr glm::vec3 front{0, 0, 1};

BerryBody ball(glm::vec3 centre, float radius = 1) { return {centre, {0, -1, 0}, radius, radius}; }

float uniform(std::uint64_t k) { return static_cast<float>(hash_combine(7, k) >> 40) / 16777216.0f; }

// `count` balls of radius 9 in a spindle, as close as a bunch's.
std::vector<BerryBody> cluster(std::uint32_t count) {
  std::vector<BerryBody> berries;
  const float size = std::cbrt(static_cast<float>(count)) * 9;
  for (std::uint32_t k = 0; k < count; ++k) {
    const glm::vec3 place{uniform(4 * k) - 0.5f, -2 * uniform(4 * k + 1), uniform(4 * k + 2) - 0.5f};
    berries.push_back({1.7f * size * place, {0, -1, 0}, 9, 9});
    berries.back().id = k;
  }
  return berries;
}

}  // namespace

TEST_CASE("a berry alone, beside another or before another is not shaded") {
  CHECK(sun_exposure({}, front).empty());
  const std::vector<BerryBody> one = {ball({0, 0, 0})};
  CHECK(sun_exposure(one, front) == std::vector<float>{1});
  const std::vector<BerryBody> two = {ball({0, 0, 0}), ball({2.2f, 0, 0}), ball({0, 0, 2})};
  const std::vector<float> exposure = sun_exposure(two, front);
  CHECK(exposure[1] == 1);
  CHECK(exposure[2] == 1);
  CHECK(exposure[0] < 0.06f);  // right behind the third, but for the penumbra
}

TEST_CASE("a half eclipse has the area of two overlapping circles") {
  // Circles of radius 1 at a distance of 1 share 2 acos ½ − √3 / 2 of π: 39.1
  // %.
  const std::vector<BerryBody> two = {ball({0, 0, 0}), ball({1, 0, 1.8f})};
  CHECK(sun_exposure(two, front)[0] == doctest::Approx(1 - 0.391f).epsilon(0.05));
  const std::vector<BerryBody> small = {ball({0, 0, 0}), ball({0, 0, 1.8f}, 0.5f)};
  CHECK(sun_exposure(small, front)[0] == doctest::Approx(0.75f).epsilon(0.05));
}

TEST_CASE("long berries shade by their outline") {
  const BerryBody upright{{0, 0, 3}, {0, -1, 0}, 0.5f, 2}, across{{0, 0, 3}, {1, 0, 0}, 0.5f, 2};
  const BerryBody above = ball({0, 1.6f, 0}, 0.3f);
  CHECK(sun_exposure(std::vector{above, upright}, front)[0] < 0.35f);
  CHECK(sun_exposure(std::vector{above, across}, front)[0] == 1);
}

TEST_CASE("exposure does not depend on order, scale or place") {
  std::vector<BerryBody> berries = cluster(150);
  const glm::vec3 sun = glm::vec3(0.4f, 0.7f, 0.6f);
  const std::vector<float> exposure = sun_exposure(berries, sun);
  std::vector<BerryBody> turned(berries.rbegin(), berries.rend());
  std::vector<float> backwards = sun_exposure(turned, 10.0f * sun);
  std::reverse(backwards.begin(), backwards.end());
  for (BerryBody& berry : berries) {
    berry.centre = 0.001f * berry.centre + glm::vec3(0.2f, 0.1f, 0);
    berry.half_width = berry.half_length = 0.009f;
  }
  const std::vector<float> metres = sun_exposure(berries, sun);
  float mean = 0;
  for (std::size_t i = 0; i < exposure.size(); ++i) {
    CHECK(exposure[i] >= 0);
    CHECK(exposure[i] <= 1);
    CHECK(backwards[i] == doctest::Approx(exposure[i]).epsilon(1e-4));
    CHECK(std::abs(metres[i] - exposure[i]) < 0.005f);
    mean += exposure[i] / static_cast<float>(exposure.size());
  }
  CHECK(mean > 0.2f);
  CHECK(mean < 0.8f);
}

TEST_CASE("a small move is a small change") {
  std::vector<BerryBody> berries = cluster(120);
  std::vector<float> before = sun_exposure(berries, front);
  float worst = 0;
  for (int step = 1; step <= 100; ++step) {
    for (BerryBody& berry : berries) {
      berry.centre += 0.09f * glm::vec3(uniform(berry.id) - 0.5f, 0.5f, uniform(berry.id + 999) - 0.5f);
    }
    const std::vector<float> after = sun_exposure(berries, front);
    for (std::size_t i = 0; i < after.size(); ++i) worst = std::max(worst, std::abs(after[i] - before[i]));
    before = after;
  }
  CHECK(worst < 0.04f);  // for a hundredth of a radius
}

TEST_CASE("extreme input gives shares from 0 to 1") {
  for (std::uint64_t k = 0; k < 200; ++k) {
    std::vector<BerryBody> berries;
    for (std::uint64_t i = 0; i < k % 40; ++i) {
      const auto draw = [&](int n) { return uniform(1000 * k + 10 * i + static_cast<std::uint64_t>(n)) - 0.5f; };
      const glm::vec3 direction = glm::normalize(glm::vec3(draw(0), draw(1), draw(2) + 0.6f));
      berries.push_back({2.0f * glm::vec3(draw(3), draw(4), draw(5)), direction, 0.5f + draw(6), 0.5f + draw(7)});
      if (i % 7 == 3) berries.push_back(berries.front());
    }
    for (const float share : sun_exposure(berries, {0, k % 2 ? 1 : -1, uniform(k) - 0.5f})) {
      CHECK(share >= 0);
      CHECK(share <= 1);
    }
  }
}
