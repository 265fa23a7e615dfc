#include "models/particles/waypoints.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/random.hpp"

using namespace panicle;
using namespace panicle::particles;

namespace {

// A U: two arms, joined below.
const Outline& horseshoe() {
  static const Outline outline({{0, 0}, {1, 0}, {1, 1}, {0.7f, 1}, {0.7f, 0.3f}, {0.3f, 0.3f}, {0.3f, 1}, {0, 1}});
  return outline;
}

}  // namespace

TEST_CASE("waypoints lead round corners to the goal, on ways that stay inside and are about the shortest") {
  const Outline& outline = horseshoe();
  const glm::vec3 goal(0.15f, 0.95f, 0);
  Waypoints ways(outline, {goal}, 0.02f);
  for (std::uint64_t k = 0; k < 400; ++k) {
    glm::vec3 p(random_unit(k, 1, 0), random_unit(k, 2, 0), 0);
    if (!outline.contains(p)) continue;
    CAPTURE(k);
    const float promised = ways.way(p);
    // The shortest goes by the corners of the gap.
    const glm::vec3 near(0.3f, 0.3f, 0), far(0.7f, 0.3f, 0);
    float shortest = glm::distance(p, goal);
    if (!outline.holds(p, goal)) {
      shortest = outline.holds(p, near + glm::vec3(-1e-4f, -1e-4f, 0))
                     ? glm::distance(p, near)
                     : glm::distance(p, far) + glm::distance(far, near);
      shortest += glm::distance(near, goal);
    }
    CHECK(promised >= 0.99f * shortest);
    CHECK(promised <= 1.1f * shortest + 0.05f);
    int turns = 0;
    for (; turns < 20 && glm::distance(p, goal) > 1e-3f; ++turns) {
      const glm::vec3 next = ways.next(p);
      if (next != goal) CHECK(outline.holds(p, next));
      p = next;
    }
    CHECK(turns < 20);
  }
}

TEST_CASE("the way leads to the nearest of several goals") {
  Waypoints ways(horseshoe(), {{0.15f, 0.95f, 0}, {0.85f, 0.95f, 0}}, 0.02f);
  CHECK(ways.next({0.1f, 0.5f, 0}).x < 0.5f);
  CHECK(ways.next({0.9f, 0.5f, 0}).x > 0.5f);
  // In a straight line the other arm is nearer; along ways inside it is not.
  CHECK(ways.way({0.28f, 0.9f, 0}) < 0.2f);
}

TEST_CASE("there is a way from outside, and where no cell is inside") {
  Waypoints ways(horseshoe(), {{0.15f, 0.95f, 0}}, 0.02f);
  const glm::vec3 outside(0.5f, 0.7f, 0), next = ways.next(outside);
  CHECK(horseshoe().contains(next));
  const Outline sliver({{0, 0}, {1, 0}, {1, 1e-4f}, {0, 1e-4f}});
  Waypoints none(sliver, {{0, 0, 0}}, 0.1f);
  CHECK(std::isfinite(none.way({0.9f, 5e-5f, 0})));
  CHECK(none.next({0.9f, 5e-5f, 0}).x <= 1);
}

TEST_CASE("ways do not depend on the order of queries") {
  const glm::vec3 goal(0.15f, 0.95f, 0);
  Waypoints far_first(horseshoe(), {goal}, 0.02f);
  const float farthest = far_first.way({0.85f, 0.95f, 0});
  Waypoints near_first(horseshoe(), {goal}, 0.02f);
  for (std::uint64_t k = 0; k < 300; ++k) {
    const glm::vec3 p(random_unit(k, 1, 1), random_unit(k, 2, 1) * static_cast<float>(k) / 300, 0);
    CHECK(near_first.way(p) == far_first.way(p));
    CHECK(near_first.next(p) == far_first.next(p));
  }
  CHECK(near_first.way({0.85f, 0.95f, 0}) == farthest);
  // The result does not depend on the order of queries.
  for (std::uint64_t k = 0; k < 40; ++k) {
    const glm::vec3 p(random_unit(k, 1, 2), random_unit(k, 2, 2), 0);
    CHECK(Waypoints(horseshoe(), {goal}, 0.02f).way(p) == far_first.way(p));
  }
}
