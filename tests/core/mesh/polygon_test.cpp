#include "mesh/polygon.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

using namespace panicle;

namespace {

using Corners = std::vector<glm::vec3>;

double area_of(const Corners& corners, const std::vector<std::uint32_t>& triangles) {
  double area = 0;
  for (std::size_t k = 0; k < triangles.size(); k += 3) {
    const glm::dvec3 a(corners[triangles[k]]), b(corners[triangles[k + 1]]), c(corners[triangles[k + 2]]);
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return area;
}

// Invariants for every input: three different corners a triangle, not on a line, and all corners used.
void check_clean(const Corners& corners, const std::vector<std::uint32_t>& triangles) {
  REQUIRE(triangles.size() % 3 == 0);
  for (std::size_t k = 0; k < triangles.size(); k += 3) {
    for (std::size_t m = 0; m < 3; ++m) REQUIRE(triangles[k + m] < corners.size());
    const glm::dvec3 a(corners[triangles[k]]), b(corners[triangles[k + 1]]), c(corners[triangles[k + 2]]);
    const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    const double twice = glm::length(glm::cross(b - a, c - a));
    CHECK(twice - twice == 0);
    CHECK(twice > 1e-7 * longest * longest);
  }
}

Corners star(int points, float inner, float size) {
  Corners all;
  for (int i = 0; i < 2 * points; ++i) {
    const auto [sine, cosine] = sincos_degrees(180.0f * static_cast<float>(i) / static_cast<float>(points));
    const float r = (i % 2 ? inner : 1) * size;
    all.emplace_back(r * cosine, 3, r * sine);
  }
  return all;
}

}  // namespace

TEST_CASE("a simple polygon is filled exactly in both orientations") {
  const Corners square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  CHECK(area_of(square, fill_polygon(square)) == doctest::Approx(1));
  for (const float size : {1e-12f, 1.0f, 1e12f}) {
    const Corners spiky = star(7, 0.3f, size);
    const auto triangles = fill_polygon(spiky);
    check_clean(spiky, triangles);
    CHECK(triangles.size() == 3 * (14 - 2));
    const double wanted = 14 * 0.5 * 0.3 * std::sin(std::acos(-1.0) / 7) * static_cast<double>(size) * size;
    CHECK(area_of(spiky, triangles) == doctest::Approx(wanted).epsilon(1e-4));
    const Corners back(spiky.rbegin(), spiky.rend());
    CHECK(area_of(back, fill_polygon(back)) == doctest::Approx(wanted).epsilon(1e-4));
  }
}

TEST_CASE("a corner whose triangle contains another is no ear, for every first corner") {
  Corners arrow{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}};
  for (std::size_t turn = 0; turn < arrow.size(); ++turn) {
    std::rotate(arrow.begin(), arrow.begin() + 1, arrow.end());
    CHECK(area_of(arrow, fill_polygon(arrow)) == doctest::Approx(10));
  }
}

TEST_CASE("triangles run counter-clockwise seen against the polygon's normal") {
  const Corners l{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  const auto triangles = fill_polygon(l);
  CHECK(area_of(l, triangles) == doctest::Approx(3));
  for (std::size_t k = 0; k < triangles.size(); k += 3) {
    const glm::vec3 a = l[triangles[k]], b = l[triangles[k + 1]], c = l[triangles[k + 2]];
    CHECK(glm::cross(b - a, c - a).z > 0);
  }
}

TEST_CASE("a polygon that revisits points is filled without degenerate triangles") {
  // Duplicate corners, one between others on a line, a way out and back, and the first once more at the end.
  const Corners untidy{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0},
                       {3, 2, 0}, {2, 2, 0}, {0, 2, 0}, {0, 1, 0}, {0, 0, 0}};
  const auto triangles = fill_polygon(untidy);
  check_clean(untidy, triangles);
  CHECK(area_of(untidy, triangles) == doctest::Approx(4));
}

TEST_CASE("both halves of a figure of eight are filled") {
  const Corners eight{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto triangles = fill_polygon(eight);
  check_clean(eight, triangles);
  CHECK(triangles.size() == 6);
}

TEST_CASE("a polygon that is not planar is filled with all its corners") {
  const Corners bent{{0, 0, 0}, {1, 0, 0.5f}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0.5f}, {0, 1, 0}};
  const auto triangles = fill_polygon(bent);
  check_clean(bent, triangles);
  CHECK(triangles.size() == 12);
  // Folded across or along: between its floor and that with both folds.
  CHECK(area_of(bent, triangles) >= 2);
  CHECK(area_of(bent, triangles) < 2 * std::sqrt(1.25) + 1);
}

TEST_CASE("fill_polygon returns nothing for fewer than three different corners, or corners on a line") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(fill_polygon({}).empty());
  CHECK(fill_polygon(Corners{{1, 2, 3}}).empty());
  CHECK(fill_polygon(Corners{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}).empty());
  CHECK(fill_polygon(Corners{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}}).empty());
  CHECK(fill_polygon(Corners{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}}).empty());
  CHECK(fill_polygon(Corners{{0, 0, 0}, {1, 0, 0}, {nan, 0, 0}}).empty());
  const Corners with_hole{{0, 0, 0}, {1, 0, 0}, {nan, nan, nan}, {1, 1, 0}};
  CHECK(area_of(with_hole, fill_polygon(with_hole)) == doctest::Approx(0.5));
}

TEST_CASE("random polygons give valid triangles in limited time") {
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    Corners walk;
    const std::size_t count = seed < 2 ? 4000 : 3 + seed % 40;
    glm::vec3 at(0);
    for (std::size_t i = 0; i < count; ++i) {
      const auto step = [&](std::uint64_t k) {
        const float value = random_unit(seed, 7, 16 * i + k);
        // Some on a coarse lattice, so that places are met again.
        return seed % 3 ? value - 0.5f : std::floor(3 * value) - 1;
      };
      at += glm::vec3(step(0), step(1), seed % 2 ? step(2) : 0);
      walk.push_back(at);
    }
    check_clean(walk, fill_polygon(walk));
  }
}
