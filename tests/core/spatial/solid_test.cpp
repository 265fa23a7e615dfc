#include "spatial/solid.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>

#include "foundation/random.hpp"
#include "spatial/surfaces.hpp"

namespace panicle {
namespace {

glm::vec3 dart(std::uint64_t i, float reach) {
  return reach * glm::vec3(2 * random_unit(7, 1, i) - 1, 2 * random_unit(7, 2, i) - 1, 2 * random_unit(7, 3, i) - 1);
}

bool in_corner(const glm::vec3& p) {
  return p.x > 0 && p.y > 0 && p.z > 0 && p.z < 1 && p.x < 2 && p.y < 2 && (p.x < 1 || p.y < 1);
}

TEST_CASE("a box contains the places within its bounds") {
  const Solid solid(box({-1, 0, -2}, {1, 3, 2}));
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const glm::vec3 p = dart(i, 4);
    const bool inside = std::fabs(p.x) < 1 && p.y > 0 && p.y < 3 && std::fabs(p.z) < 2;
    CHECK(solid.contains(p) == inside);
  }
}

TEST_CASE("a ball contains the places within its radius, up to its facets") {
  const Solid solid(ellipsoid({1, 2, 3}, {2, 1, 1.5f}, 48));
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const glm::vec3 p = glm::vec3(1, 2, 3) + dart(i, 2.2f);
    const float from = glm::length((p - glm::vec3(1, 2, 3)) / glm::vec3(2, 1, 1.5f));
    if (from < 0.985f) CHECK(solid.contains(p));
    if (from > 1.0001f) CHECK_FALSE(solid.contains(p));
  }
}

TEST_CASE("a bay is outside, also at heights where faces and corners lie in the slice") {
  const Solid solid(corner());
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const glm::vec3 p = glm::vec3(1) + dart(i, 1.3f);
    CHECK(solid.contains(p) == in_corner(p));
  }
  CHECK_FALSE(solid.contains({1.5f, 1.5f, 0.5f}));
  // The slice through the flat face at y = 1 has the one half's cross-section or the other's, and is closed.
  for (float x = 0.05f; x < 1; x += 0.1f) CHECK(solid.contains({x, 1, 0.5f}));
  CHECK_FALSE(solid.contains({2.5f, 1, 0.5f}));
  CHECK_FALSE(solid.contains({-0.5f, 1, 0.5f}));
}

TEST_CASE("parts that overlap, touch or are inverted count by their winding number") {
  Surface two = box({0, 0, 0}, {2, 2, 2});
  append(two, box({1, 1, 1}, {3, 3, 3}));
  const Solid both(two);
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const glm::vec3 p = glm::vec3(1.5f) + dart(i, 1.8f);
    const auto in = [&p](float low, float high) {
      return p.x > low && p.x < high && p.y > low && p.y < high && p.z > low && p.z < high;
    };
    CHECK(both.contains(p) == (in(0, 2) || in(1, 3)));
  }
  Surface touching = box({0, 0, 0}, {1, 1, 1});
  append(touching, box({0, 1, 0}, {1, 2, 1}));
  const Solid stacked(touching);
  for (float y = 0.05f; y < 2; y += 0.05f) CHECK(stacked.contains({0.5f, y, 0.5f}));
  CHECK(stacked.contains({0.5f, 1, 0.5f}));
  Surface turned = box({0, 0, 0}, {1, 1, 1});
  for (std::size_t t = 0; t < turned.triangles.size(); t += 3) std::swap(turned.triangles[t], turned.triangles[t + 1]);
  CHECK(Solid(turned).contains({0.5f, 0.5f, 0.5f}));
  // A hole: a part that is turned inside out within another.
  Surface hollow = box({-1, -1, -1}, {2, 2, 2});
  append(hollow, turned);
  CHECK_FALSE(Solid(hollow).contains({0.5f, 0.5f, 0.5f}));
  CHECK(Solid(hollow).contains({1.5f, 0.5f, 0.5f}));
}

TEST_CASE("share_of a box agrees with contains for every place in it") {
  const Solid solid(ellipsoid({0, 0, 0}, {1, 1, 1}, 32));
  int sure = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const glm::vec3 low = dart(i, 1.1f), high = low + 0.1f;
    const Share share = solid.share_of(low, high);
    if (share == Share::some) continue;
    ++sure;
    for (std::uint64_t k = 0; k < 8; ++k) {
      const glm::vec3 p = low + 0.1f * (0.5f * dart(8 * i + k, 1) + 0.5f);
      CHECK(solid.contains(p) == (share == Share::all));
    }
  }
  CHECK(sure > 1500);
  CHECK(solid.share_of({-0.1f, -0.1f, -0.1f}, {0.1f, 0.1f, 0.1f}) == Share::all);
  CHECK(solid.share_of({2, 2, 2}, {3, 3, 3}) == Share::none);
}

TEST_CASE("share_of is as sharp for distant parts as for one") {
  Surface two = ellipsoid({0, 0, 0}, {1, 1, 1}, 32);
  append(two, ellipsoid({100, 0, 0}, {1, 1, 1}, 32));
  const Solid solid(two);
  CHECK(solid.share_of({99.9f, -0.1f, -0.1f}, {100.1f, 0.1f, 0.1f}) == Share::all);
  CHECK(solid.share_of({40, -0.5f, -0.5f}, {60, 0.5f, 0.5f}) == Share::none);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const glm::vec3 p = dart(i, 1.1f);
    const float length = glm::length(p);
    if (length < 0.95f || length > 1) CHECK(solid.contains(p + glm::vec3(100, 0, 0)) == (length < 1));
  }
}

// By the turns of all triangles, one by one: the solid angle that each takes up (van Oosterom and Strackee 1983).
bool winds_about(const Surface& surface, const glm::dvec3& p) {
  double sum = 0;
  for (std::size_t t = 0; t + 2 < surface.triangles.size(); t += 3) {
    const auto to = [&](std::size_t k) { return glm::dvec3(surface.points[surface.triangles[t + k]]) - p; };
    const glm::dvec3 a = to(0), b = to(1), c = to(2);
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    sum += 2 * std::atan2(glm::dot(a, glm::cross(b, c)),
                          la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
  }
  return std::fabs(sum) > 6;
}

TEST_CASE("the index of large triangles has larger cells and a bounded size, and finds the same places inside") {
  const Surface surface = spanning_tetrahedra(400);
  const auto budget = std::make_shared<QueryBudget>(QueryBudget::usual, 1000);
  const Solid coarse(surface, budget), fine(surface);
  CHECK(budget->members_each() < 5000);
  CHECK(coarse.members() <= budget->members_each());
  CHECK(fine.members() > 20 * coarse.members());
  CHECK(fine.members() <= QueryBudget().members_each());
  int inside = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const glm::vec3 p = 0.5f + dart(i, 0.5f);
    const bool is_inside = winds_about(surface, p);
    CHECK(fine.contains(p) == is_inside);
    CHECK(coarse.contains(p) == is_inside);
    inside += is_inside;
  }
  CHECK(inside > 300);
}

TEST_CASE("the index of very many large triangles has a bounded size") {
  const Surface surface = spanning_tetrahedra(8000);
  CHECK(Solid(surface).members() <= QueryBudget().members_each());
}

TEST_CASE("a solid whose budget is used up contains no place and is exhausted") {
  const Surface surface = spanning_tetrahedra(400);
  const auto budget = std::make_shared<QueryBudget>(), small = std::make_shared<QueryBudget>(1'000'000);
  const Solid solid(surface, budget), refused(surface, small);
  const std::uint64_t before = budget->left();
  int inside = 0, looked = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) inside += solid.contains(0.5f + dart(i, 0.5f));
  CHECK(before - budget->left() > 1000 * 100);
  CHECK(inside > 300);
  CHECK_FALSE(solid.is_exhausted());
  for (std::uint64_t i = 0; i < 1'000'000 && !refused.is_exhausted(); ++i, ++looked)
    refused.contains(0.5f + dart(i, 0.5f));
  CHECK(refused.is_exhausted());
  CHECK(looked < 10'000);
  for (std::uint64_t i = 0; i < 1000; ++i) CHECK_FALSE(refused.contains(0.5f + dart(i, 0.5f)));
  CHECK(refused.exit_distance({0.5f, 0.5f, 0.5f}, {1, 0, 0}, 1) == 0);
  // Another solid of the same plant has the same budget.
  CHECK(Solid(box({0, 0, 0}, {1, 1, 1}), small).is_exhausted());
  CHECK(QueryBudget::error().reason == Reason::limit);
  // A ray that meets triangles is counted, too.
  const std::uint64_t then = budget->left();
  for (std::uint64_t i = 0; i < 100; ++i) solid.exit_distance(0.5f + dart(i, 0.5f), {1, 0, 0}, 1);
  CHECK(then - budget->left() > 100 * 400);
}

TEST_CASE("a surface without triangles contains no place, nor do places that are not finite") {
  const Solid none({});
  CHECK_FALSE(none.contains({0, 0, 0}));
  CHECK(none.share_of({0, 0, 0}, {1, 1, 1}) != Share::all);
  const Solid solid(box({0, 0, 0}, {1, 1, 1}));
  CHECK_FALSE(solid.contains({NAN, 0.5f, 0.5f}));
  CHECK_FALSE(solid.contains({0.5f, INFINITY, 0.5f}));
  const Solid flat(box({0, 0, 0}, {1, 0, 1}));
  CHECK_FALSE(flat.contains({0.5f, 0.5f, 0.5f}));
  const Solid point(box({1, 1, 1}, {1, 1, 1}));
  CHECK_FALSE(point.contains({1, 1, 1.5f}));
}

}  // namespace
}  // namespace panicle
