#include "models/particles/scatter.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "near.hpp"
#include "shapes.hpp"

using namespace panicle;
using namespace panicle::particles;

namespace {

constexpr Pattern patterns[] = {Pattern::uniform, Pattern::jittered, Pattern::blue};

// The least distance between two points.
float closest(const std::vector<glm::vec3>& points) {
  float least = 1e9f;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) least = std::min(least, glm::distance(points[a], points[b]));
  return least;
}

// The widest gap: the greatest distance of a place inside from all points.
float widest_gap(const Region& region, const std::vector<glm::vec3>& points, float grid) {
  float widest = 0;
  const float deep = region.flat() ? 0 : region.high().z;
  for (float z = -deep; z <= deep; z += grid)
    for (float y = -1; y <= 1; y += grid)
      for (float x = -1; x <= 1; x += grid) {
        const glm::vec3 place(x, y, z);
        if (!region.contains(place)) continue;
        float nearest = 1e9f;
        for (const glm::vec3& p : points) nearest = std::min(nearest, glm::distance(place, p));
        widest = std::max(widest, nearest);
      }
  return widest;
}

}  // namespace

TEST_CASE("the spacing of points is the root of the area or volume of each") {
  CHECK(spacing_of(Round(true), 1000) == near(std::sqrt(3.14159f / 1000), 0.01));
  CHECK(spacing_of(Round(false), 1000) == near(std::cbrt(4.18879f / 1000), 0.01));
  CHECK(spacing_of(Round(false, 1, 0.8f), 1000) == near(std::cbrt(4.18879f * 0.488f / 1000), 0.02));
  CHECK(spacing_of(Shaded(), 1000) == near(std::sqrt(2.5f / 1000), 0.01));
  CHECK(spacing_of(Round(true), 0) == 0);
}

TEST_CASE(
    "no particle starts outside the outer boundary or inside the inner one, and about as many do as were asked for") {
  for (const bool flat : {true, false})
    for (const float hole : {0.0f, 0.75f})
      for (const Pattern pattern : patterns)
        for (const std::uint32_t count : {50u, 500u, 5000u}) {
          CAPTURE(flat);
          CAPTURE(hole);
          CAPTURE(static_cast<int>(pattern));
          CAPTURE(count);
          const Round region(flat, 1, hole);
          const auto points = scatter(region, pattern, count, spacing_of(region, count), 7);
          CHECK(std::all_of(points.begin(), points.end(), [&](const glm::vec3& p) { return region.contains(p); }));
          // Points of small regions may lie a little outside of the filled part, so more of them fit.
          const float off = count == 50 ? 0.75f : count == 500 ? 0.35f : 0.15f;
          CHECK(static_cast<float>(points.size()) == doctest::Approx(static_cast<float>(count)).epsilon(off));
          if (pattern == Pattern::uniform) CHECK(points.size() == count);
        }
}

TEST_CASE("exactly the requested number starts, for few points, in a shell and in a region dense in one place alone") {
  for (const bool flat : {true, false})
    for (const float hole : {0.0f, 0.95f})
      for (const Pattern pattern : patterns)
        for (const std::uint32_t count : {1u, 2u, 10u, 50u, 300u, 2000u})
          for (std::uint64_t seed = 1; seed < 6; ++seed) {
            CAPTURE(flat);
            CAPTURE(hole);
            CAPTURE(static_cast<int>(pattern));
            CAPTURE(count);
            CAPTURE(seed);
            const Round region(flat, 1, hole);
            const Scattered scattered = scatter_all(region, pattern, count, seed);
            CHECK(scattered.points.size() == count);
            CHECK(scattered.spacing == spacing_of(region, count));
            CHECK(std::all_of(scattered.points.begin(), scattered.points.end(),
                              [&](const glm::vec3& p) { return region.contains(p); }));
          }
  for (const Pattern pattern : patterns) CHECK(scatter_all(Shaded(), pattern, 3000, 1).points.size() == 3000);
}

TEST_CASE("blue noise of the requested number is even") {
  for (const bool flat : {true, false}) {
    CAPTURE(flat);
    const Round region(flat);
    const auto [points, spacing, extent] = scatter_all(region, Pattern::blue, 600, 3);
    CHECK(closest(points) >= 0.75f * spacing);
    CHECK(widest_gap(region, points, flat ? 0.02f : 0.1f) < 1.35f * spacing);
  }
}

TEST_CASE("a region of half the size has an eighth of the points, and jittered ones stay") {
  for (const Pattern pattern : {Pattern::jittered, Pattern::blue}) {
    CAPTURE(static_cast<int>(pattern));
    const Round grown(false), half(false, 0.5f);
    const auto all = scatter_all(grown, pattern, 4000, 1), some = scatter_all(half, pattern, 4000, 1, 0.5f);
    CHECK(static_cast<float>(some.points.size()) == doctest::Approx(500).epsilon(0.2));
    CHECK(some.spacing == doctest::Approx(all.spacing).epsilon(1e-4));
    const auto stay = std::count_if(some.points.begin(), some.points.end(), [&](const glm::vec3& p) {
      return std::any_of(all.points.begin(), all.points.end(), [&](auto& q) { return glm::distance(p, q) < 0.02f; });
    });
    if (pattern == Pattern::jittered) CHECK(static_cast<float>(stay) > 0.95f * static_cast<float>(some.points.size()));
  }
}

TEST_CASE("blue noise keeps its distance and leaves no holes; uniform points do neither") {
  for (const bool flat : {true, false}) {
    CAPTURE(flat);
    const Round region(flat);
    const float spacing = spacing_of(region, 600);
    const auto even = scatter(region, Pattern::blue, 600, spacing, 3);
    const auto loose = scatter(region, Pattern::uniform, 600, spacing, 3);
    CHECK(closest(even) >= 0.75f * spacing);
    CHECK(closest(loose) < 0.3f * spacing);
    const float grid = flat ? 0.02f : 0.1f;
    CHECK(widest_gap(region, even, grid) < 1.15f * spacing);
    CHECK(widest_gap(region, loose, grid) > 1.3f * spacing);
  }
}

TEST_CASE("where a region's density is a quarter, a quarter as many start") {
  const Shaded region;
  for (const Pattern pattern : patterns) {
    CAPTURE(static_cast<int>(pattern));
    const auto points = scatter(region, pattern, 4000, spacing_of(region, 4000), 5);
    const auto bright =
        static_cast<float>(std::count_if(points.begin(), points.end(), [](auto& p) { return p.x < 0; }));
    const auto dark = static_cast<float>(points.size()) - bright;
    CHECK(dark / bright == near(0.25, 0.12));
    CHECK(static_cast<float>(points.size()) == doctest::Approx(4000).epsilon(0.06));
  }
}

TEST_CASE("a region that grows keeps the points that it has, and another seed gives others") {
  const auto key = [](const glm::vec3& p) { return std::tuple(p.x, p.y, p.z); };
  const auto share_of_old = [&](const std::vector<glm::vec3>& now, const std::vector<glm::vec3>& before) {
    std::set<std::tuple<float, float, float>> all;
    for (const glm::vec3& p : now) all.insert(key(p));
    return static_cast<float>(
               std::count_if(before.begin(), before.end(), [&](auto& p) { return all.contains(key(p)); })) /
           static_cast<float>(before.size());
  };
  for (const Pattern pattern : {Pattern::jittered, Pattern::blue}) {
    const auto before = scatter(Round(true, 1), pattern, 0, 0.05f, 1);
    CHECK(share_of_old(scatter(Round(true, 1.04f), pattern, 0, 0.05f, 1), before) > 0.9f);
    CHECK(share_of_old(scatter(Round(true, 1), pattern, 0, 0.05f, 2), before) == 0);
  }
}

namespace {

// Two balls far apart, which count the queries of places.
class FarApart final : public Region {
 public:
  glm::vec3 low() const override { return {-1, -1, -1}; }
  glm::vec3 high() const override { return {201, 1, 1}; }
  bool contains(const glm::vec3& p) const override {
    ++queries;
    return glm::length(p) < 1 || glm::distance(p, glm::vec3(200, 0, 0)) < 1;
  }
  Share share_of(const glm::vec3& from, const glm::vec3& to) const override {
    return from.x > 1 && to.x < 199 ? Share::none : Share::some;
  }
  mutable std::uint64_t queries = 0;
};

}  // namespace

TEST_CASE("empty space is not queried place by place") {
  const FarApart region;
  const auto points = scatter(region, Pattern::jittered, 8000, 0.1f, 1);
  CHECK(points.size() > 7000);
  CHECK(region.queries < 8 * points.size());
}

TEST_CASE("a region without extent has no points, and scattering ends") {
  for (const Pattern pattern : patterns) {
    CHECK(scatter(Round(true, 0), pattern, 100, spacing_of(Round(true, 0), 100), 1).empty());
    CHECK(scatter(Round(false, 1, 2), pattern, 100, spacing_of(Round(false, 1, 2), 100), 1).empty());
  }
}
