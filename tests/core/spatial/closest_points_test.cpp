#include "spatial/closest_points.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "foundation/random.hpp"

using namespace panicle;

namespace {

constexpr float parallel = 1e-5f;

double distance_at(const glm::vec3& between, const Extent& a, double s, const Extent& b, double t) {
  return glm::length(glm::dvec3(between) + glm::dvec3(b.way) * t - glm::dvec3(a.way) * s);
}

// The least distance, looking at points of both ever more closely about the best.
double least_distance(const glm::vec3& between, const Extent& a, const Extent& b) {
  double s = 0, t = 0, width_s = a.reach, width_t = b.reach, least = std::numeric_limits<double>::max();
  for (int round = 0; round < 24; ++round) {
    const double middle_s = s, middle_t = t;
    for (int i = -8; i <= 8; ++i)
      for (int j = -8; j <= 8; ++j) {
        const double at_s = std::clamp(middle_s + width_s * i / 8, -double{a.reach}, double{a.reach});
        const double at_t = std::clamp(middle_t + width_t * j / 8, -double{b.reach}, double{b.reach});
        const double here = distance_at(between, a, at_s, b, at_t);
        if (here < least) least = here, s = at_s, t = at_t;
      }
    width_s /= 2;
    width_t /= 2;
  }
  return least;
}

Extent random_extent(std::uint64_t seed, std::uint64_t i, bool unit) {
  const float length = unit ? 1 : 0.2f + 3 * random_unit(seed, 1, i);
  const glm::vec3 way = random_direction(seed, 2, i) * length;
  return {way, 4 * random_unit(seed, 3, i), unit ? 1 : glm::dot(way, way)};
}

}  // namespace

TEST_CASE("closest points are as near as looking everywhere finds") {
  for (std::uint64_t i = 0; i < 600; ++i) {
    CAPTURE(i);
    Extent a = random_extent(1, i, i % 2 == 0), b = random_extent(2, i, i % 3 == 0);
    if (i % 7 == 0) b.way = a.way, b.square = a.square;   // side by side
    if (i % 7 == 1) b.way = -a.way, b.square = a.square;  // the other way round
    if (i % 11 == 0) a.reach = 0;                         // a point
    if (i % 13 == 0) a = {glm::vec3(0), 1, 0};            // no way at all
    if (i % 17 == 0) b = {glm::vec3(0), 1, 0};
    const glm::vec3 between = random_direction(3, 1, i) * (6 * random_unit(3, 2, i));
    const auto [s, t] = closest_points(between, a, b, parallel);
    CHECK(std::fabs(s) <= a.reach);
    CHECK(std::fabs(t) <= b.reach);
    CHECK(distance_at(between, a, s, b, t) <= least_distance(between, a, b) + 1e-3);
  }
}

TEST_CASE("closest points of crossing segments are the crossing") {
  const auto [s, t] = closest_points({1, -2, 0}, {{1, 0, 0}, 5}, {{0, 1, 0}, 5}, parallel);
  CHECK(s == 1);
  CHECK(t == 2);
}

TEST_CASE("closest points of parallel segments start at the first's middle") {
  const auto [s, t] = closest_points({0.5f, 1, 0}, {{1, 0, 0}, 3}, {{1, 0, 0}, 3}, parallel);
  CHECK(s == 0);
  CHECK(t == -0.5f);
}
