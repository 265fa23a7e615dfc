#include "mesh/triangulation.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

using namespace panicle;

namespace {

glm::vec2 lattice(float x, float y) {
  const auto snapped = [](float v) { return std::floor(v * triangulation_lattice + 0.5f) / triangulation_lattice; };
  return {snapped(x), snapped(y)};
}

std::vector<glm::vec2> star(std::size_t points, float inner) {
  std::vector<glm::vec2> all;
  for (std::size_t i = 0; i < 2 * points; ++i) {
    const auto [sine, cosine] = sincos_degrees(180.0f * static_cast<float>(i) / static_cast<float>(points));
    all.push_back(lattice((i % 2 ? inner : 1) * cosine, (i % 2 ? inner : 1) * sine));
  }
  return all;
}

double twice_area(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
  const glm::dvec2 u = glm::dvec2(b) - glm::dvec2(a), v = glm::dvec2(c) - glm::dvec2(a);
  return u.x * v.y - u.y * v.x;
}

// Every triangle counter-clockwise, every edge between two of them or of the ring, and the ring's area exactly.
void check_fills(const std::vector<glm::vec2>& points, std::size_t ring, const std::vector<std::uint32_t>& triangles) {
  REQUIRE(!triangles.empty());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double area = 0, wanted = 0;
  for (std::size_t k = 0; k < triangles.size(); k += 3) {
    const std::uint32_t a = triangles[k], b = triangles[k + 1], c = triangles[k + 2];
    const double twice = twice_area(points[a], points[b], points[c]);
    CHECK(twice > 0);
    area += twice;
    ++edges[{a, b}];
    ++edges[{b, c}];
    ++edges[{c, a}];
  }
  for (std::size_t i = 0; i < ring; ++i) wanted += twice_area({0, 0}, points[i], points[(i + 1) % ring]);
  CHECK(area == doctest::Approx(wanted).epsilon(1e-12));
  std::size_t open = 0;
  for (const auto& [edge, count] : edges) {
    CHECK(count == 1);
    if (edges.contains({edge.second, edge.first})) continue;
    ++open;
    CHECK((edge.first + 1) % ring == edge.second);
  }
  CHECK(open == ring);
}

}  // namespace

TEST_CASE("a polygon is filled exactly, with random lobes and inner points") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    std::vector<glm::vec2> points = star(3 + seed % 20, 0.05f + 0.9f * random_unit(seed, 1, 0));
    const std::size_t ring = points.size();
    for (std::uint64_t k = 0; k < 12 * seed; ++k)
      points.push_back(lattice(2 * random_unit(seed, 2, k) - 1, 2 * random_unit(seed, 3, k) - 1));
    check_fills(points, ring, triangulate(points, ring));
  }
}

TEST_CASE(
    "points on a lattice, where all circles agree, are filled too; those twice there, outside or on the edge are left "
    "out") {
  std::vector<glm::vec2> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int pass = 0; pass < 2; ++pass)
    for (float y = 0; y <= 1.25f; y += 0.125f)
      for (float x = -0.25f; x <= 1; x += 0.125f) points.push_back({x, y});
  const auto triangles = triangulate(points, 4);
  check_fills(points, 4, triangles);
  CHECK(std::set<std::uint32_t>(triangles.begin(), triangles.end()).size() == 4 + 7 * 7);
}

TEST_CASE("away from the polygon's edges no corner lies in another triangle's circle") {
  std::vector<glm::vec2> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::uint64_t k = 0; k < 120; ++k) points.push_back(lattice(random_unit(5, 1, k), random_unit(5, 2, k)));
  const auto triangles = triangulate(points, 4);
  check_fills(points, 4, triangles);
  for (std::size_t k = 0; k < triangles.size(); k += 3) {
    const glm::dvec2 a(points[triangles[k]]), b(points[triangles[k + 1]]), c(points[triangles[k + 2]]);
    const double d = 2 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    const double bb = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y),
                 cc = (c.x - a.x) * (c.x - a.x) + (c.y - a.y) * (c.y - a.y);
    const glm::dvec2 centre(a.x + ((c.y - a.y) * bb - (b.y - a.y) * cc) / d,
                            a.y + ((b.x - a.x) * cc - (c.x - a.x) * bb) / d);
    const double square = (centre.x - a.x) * (centre.x - a.x) + (centre.y - a.y) * (centre.y - a.y);
    for (const glm::vec2& p : points) {
      const double x = static_cast<double>(p.x) - centre.x, y = static_cast<double>(p.y) - centre.y;
      CHECK(x * x + y * y >= square * (1 - 1e-9));
    }
  }
}

TEST_CASE("triangulate counts its steps and returns nothing beyond the limit") {
  // A comb of 400 narrow teeth: each side of a tooth crosses the edges between those before it.
  std::vector<glm::vec2> comb;
  for (int k = 0; k < 400; ++k) {
    const float x = static_cast<float>(k) / 128;
    comb.push_back(lattice(x, 0));
    comb.push_back(lattice(x + 0.004f, k % 2 ? 4.0f : 0.5f));
  }
  comb.push_back(lattice(3.2f, -1));
  comb.push_back(lattice(-0.1f, -1));
  std::reverse(comb.begin(), comb.end());
  const std::size_t ring = comb.size();
  check_fills(comb, ring, triangulate(comb, ring));
  CHECK(triangulate(comb, ring, 1000).empty());
  CHECK_FALSE(triangulate(comb, ring, 1'000'000).empty());
}

TEST_CASE("triangulate returns nothing for fewer than three points or a polygon that crosses itself") {
  const std::vector<glm::vec2> bow{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  CHECK(triangulate(bow, 4).empty());
  CHECK(triangulate(std::span(bow).first(2), 2).empty());
  CHECK(triangulate(std::span(bow).first(2), 3).empty());
}
