#include "models/particles/outline.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

using namespace panicle;
using namespace panicle::particles;

namespace {

// A star about the origin, in either sense.
std::vector<glm::vec2> star(std::size_t points, float inner, bool clockwise) {
  std::vector<glm::vec2> all;
  for (std::size_t i = 0; i < 2 * points; ++i) {
    const auto [sine, cosine] = sincos_degrees(180.0f * static_cast<float>(i) / static_cast<float>(points));
    const float radius = i % 2 ? inner : 1.0f;
    all.push_back({radius * cosine, (clockwise ? -radius : radius) * sine});
  }
  return all;
}

// By the angles at which the corners are seen: sums to 0 outside, to whole turns inside.
bool holds_by_angles(const std::vector<glm::vec2>& points, const glm::vec2& p) {
  float turned = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec2 a = points[i] - p, b = points[(i + 1) % points.size()] - p;
    turned += arc_tangent(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
  }
  return std::fabs(turned) > 3;
}

}  // namespace

TEST_CASE("an outline of either sense contains the places with a winding number, lobed or not") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    std::vector<glm::vec2> points = star(3 + seed % 9, 0.2f + 0.7f * random_unit(seed, 1, 0), seed % 2);
    if (seed % 5 == 0)  // crossing itself at random
      for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = {random_unit(seed, 2, i) - 0.5f, random_unit(seed, 3, i) - 0.5f};
    const Outline outline(points);
    for (std::uint64_t k = 0; k < 200; ++k) {
      const glm::vec2 p(2.4f * random_unit(seed, 4, k) - 1.2f, 2.4f * random_unit(seed, 5, k) - 1.2f);
      CHECK(outline.contains({p.x, p.y, 0}) == holds_by_angles(points, p));
    }
  }
}

TEST_CASE("an outline's rows give the same result as all its edges") {
  const Outline outline(star(7, 0.4f, false));
  std::size_t held = 0;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const glm::vec3 a(2 * random_unit(k, 1, 0) - 1, 2 * random_unit(k, 2, 0) - 1, 0);
    const glm::vec3 b(2 * random_unit(k, 3, 0) - 1, 2 * random_unit(k, 4, 0) - 1, 0);
    if (!outline.contains(a) || !outline.contains(b)) continue;
    bool inside = true;
    for (int t = 0; t <= 200; ++t) inside = inside && outline.contains(a + (b - a) * (static_cast<float>(t) / 200));
    // Steps of a 200th can miss a corner that is cut, never find one that is not.
    if (!inside) CHECK_FALSE(outline.holds(a, b));
    held += outline.holds(a, b);
  }
  CHECK(held > 100);
}

TEST_CASE("an outline's area and distances follow from geometry") {
  const Outline square({{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  CHECK(square.area() == doctest::Approx(2));
  CHECK(square.distance({1, 0.5f, 0}) == doctest::Approx(0.5));
  CHECK(square.distance({3, 2, 0}) == doctest::Approx(std::sqrt(2.0)));
  CHECK(square.distance({-0.25f, 0.5f, 0}) == doctest::Approx(0.25));
  CHECK(Outline(star(200, 1, true)).area() == doctest::Approx(3.14159).epsilon(0.001));
  CHECK(square.flat());
}

TEST_CASE("an outline of fewer than three points is empty") {
  for (const std::size_t count : {0u, 1u, 2u}) {
    const Outline outline(std::vector<glm::vec2>(count, glm::vec2(0.5f, 0.5f)));
    CHECK_FALSE(outline.contains({0.5f, 0.5f, 0}));
    CHECK(outline.area() == 0);
  }
}

TEST_CASE(
    "an outline tells of any place and reach whether an edge is within, and of straight ways what all edges would") {
  const std::vector<glm::vec2> points = star(40, 0.7f, false);
  const Outline outline(points);
  std::size_t near = 0, open = 0;
  for (std::uint64_t k = 0; k < 3000; ++k) {
    const glm::vec3 p(2.6f * random_unit(k, 1, 0) - 1.3f, 2.6f * random_unit(k, 2, 0) - 1.3f, 0);
    const float reach = 0.3f * random_unit(k, 3, 0) * random_unit(k, 4, 0);
    CHECK(outline.keeps_off(p, reach) == (outline.distance(p) >= reach));
    near += outline.distance(p) < reach;
    CHECK(outline.clearance(p) <= outline.distance(p) + 1e-6f);
    const glm::vec3 q =
        p + 0.3f * (glm::vec3(random_unit(k, 5, 0), random_unit(k, 6, 0), 0) - glm::vec3(0.5f, 0.5f, 0));
    if (!outline.contains(p) || !outline.contains(q)) continue;
    bool crossed = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::vec2 a = points[i], way = points[(i + 1) % points.size()] - a, pq(q.x - p.x, q.y - p.y),
                      ap(p.x - a.x, p.y - a.y);
      const float turn = way.x * pq.y - way.y * pq.x;
      const float t = (way.y * ap.x - way.x * ap.y) / turn, u = (pq.y * ap.x - pq.x * ap.y) / turn;
      crossed = crossed || (t >= 0 && t <= 1 && u >= 0 && u <= 1);
    }
    CHECK(outline.holds(p, q) == !crossed);
    open += !crossed;
  }
  CHECK(near > 50);
  CHECK(open > 500);
}
