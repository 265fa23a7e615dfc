#include "spatial/sphere_overlaps.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/random.hpp"

using namespace panicle;

namespace {

std::vector<Sphere> random_spheres(std::uint64_t seed) {
  std::vector<Sphere> spheres(static_cast<std::size_t>(random_integer(seed, 0, 0, 0, 120)));
  const float stretch = seed % 4 == 0 ? 1000.0f : 1.0f;  // a few far away
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const auto unit = [&](std::uint64_t stream) { return random_unit(seed, stream, i) - 0.5f; };
    spheres[i].centre =
        glm::vec3(unit(1), seed % 3 == 0 ? 0.0f : unit(2), unit(3)) * (i % 9 == 0 ? 10 * stretch : 10.0f);
    spheres[i].radius = 0.3f + unit(4) * 0.6f * (i % 7 == 0 ? 4.0f : 1.0f);  // some less than nothing
  }
  return spheres;
}

std::vector<SpherePair> pairs_of(std::span<const Sphere> spheres) {
  std::vector<SpherePair> found;
  SphereOverlapQuery(spheres).pairs(found);
  return found;
}

// How far a place is from a stem, in double.
double distance_from(const glm::vec3& start, const glm::vec3& end, const glm::vec3& place) {
  const glm::dvec3 way = glm::dvec3(end) - glm::dvec3(start), to = glm::dvec3(place) - glm::dvec3(start);
  const double square = glm::dot(way, way);
  const double t = square > 0 ? std::clamp(glm::dot(way, to) / square, 0.0, 1.0) : 0;
  return glm::length(to - way * t);
}

}  // namespace

TEST_CASE("pairs equals a search through all, in order") {
  std::size_t all = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const std::vector<Sphere> spheres = random_spheres(seed);
    std::vector<SpherePair> expected;
    for (std::uint32_t a = 0; a < spheres.size(); ++a) {
      for (std::uint32_t b = a + 1; b < spheres.size(); ++b) {
        if (spheres[a].radius < 0 || spheres[b].radius < 0) continue;
        const glm::vec3 way = spheres[b].centre - spheres[a].centre;
        const float reach = spheres[a].radius + spheres[b].radius;
        if (glm::dot(way, way) <= reach * reach) expected.push_back({a, b});
      }
    }
    all += expected.size();
    CHECK(pairs_of(spheres) == expected);
    std::vector<SpherePair> few;
    SphereOverlapQuery(spheres).pairs(few, 5);
    expected.resize(std::min<std::size_t>(expected.size(), 5));
    CHECK(few == expected);
  }
  CHECK(all > 500);
}

TEST_CASE("along finds the same spheres as a search through all, for stems of any length") {
  std::size_t all = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const std::vector<Sphere> spheres = random_spheres(seed);
    SphereOverlapQuery touching(spheres);
    for (std::uint64_t k = 0; k < 40; ++k) {
      const glm::vec3 start = random_direction(seed, 10, k) * (8 * random_unit(seed, 11, k));
      const float lengths[] = {0, 1e-3f, 1, 5, 40, 3000};
      const glm::vec3 end = start + random_direction(seed, 12, k) * lengths[k % 6];
      const float radius = random_unit(seed, 13, k);
      const std::span<const std::uint32_t> found = touching.along(start, end, radius);
      CHECK(std::is_sorted(found.begin(), found.end()));
      for (std::uint32_t i = 0; i < spheres.size(); ++i) {
        if (spheres[i].radius < 0) continue;
        const double off = distance_from(start, end, spheres[i].centre) - radius - spheres[i].radius;
        const bool has = std::binary_search(found.begin(), found.end(), i);
        if (std::fabs(off) > 1e-3) CHECK(has == (off < 0));
        all += has;
      }
    }
  }
  CHECK(all > 900);
}

TEST_CASE("spheres that are not finite or have a negative radius touch nothing; build replaces all spheres") {
  constexpr float infinite = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Sphere> spheres = {{{0, 0, 0}, 1},   {{infinite, 0, 0}, 1}, {{1, 0, 0}, 1}, {{0, 0, 0}, infinite},
                                       {{0, nan, 0}, 1}, {{0, 0, 0}, nan},      {{0, 0, 0}, -1}};
  CHECK(pairs_of(spheres) == std::vector<SpherePair>{{0, 2}});
  CHECK(pairs_of({}).empty());
  SphereOverlapQuery touching(spheres);
  CHECK(touching.along({0, 5, 0}, {0, -5, 0}, 0.1f).size() == 2);
  for (const glm::vec3& nowhere : {glm::vec3(nan), glm::vec3(0, nan, 0), glm::vec3(infinite)})
    CHECK(touching.along({0, 0, 0}, nowhere, 1).empty());
  touching.build(std::vector<Sphere>{{{9, 9, 9}, 1}});
  CHECK(touching.along({0, 5, 0}, {0, -5, 0}, 0.1f).empty());
}
