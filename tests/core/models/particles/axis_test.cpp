#include "models/particles/axis.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "models/particles/space_growing.hpp"

namespace panicle::particles {
namespace {

TEST_CASE("an axis begins at its foot, strays by the given length, and each seed has its own axis") {
  const glm::vec3 foot(1, 0, 2);
  const Axis upright(foot);
  CHECK(upright.at(5) == glm::vec3(1, 5, 2));
  CHECK(upright.step_towards({0, 0, 0}, {4, 0, 0}, 1) == glm::vec3(4, 0, 0));
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Axis axis(foot, 10, 0.5f, seed);
    CHECK(axis.at(0) == foot);
    float farthest = 0;
    for (float y = 0; y <= 10; y += 0.25f) farthest = std::max(farthest, upright.distance(axis.at(y)));
    CHECK(farthest > 0.15f);
    CHECK(farthest < 1.2f);
    CHECK(axis.distance(axis.at(3)) == 0);
    // A place that follows the axis stays on it.
    CHECK(axis.distance(axis.step_towards(axis.at(4), axis.at(2), 0.5f)) < 1e-4f);
    CHECK(glm::distance(Axis(foot, 10, 0.5f, seed + 1).at(8), axis.at(8)) > 0.05f);
  }
}

TEST_CASE("a trunk sways, in one line of wood") {
  const auto largest_offset = [](float sway) {
    const Plant plant = grow_tree({.parameters = {{"particles", 1500}, {"sway", sway}}});
    check_sound(plant, 1);
    // The thickest segment half-way up is the trunk.
    float thickest = 0, off = 0;
    for (const Segment& segment : plant.segments) {
      if (segment.start.y > 3.5f || segment.end.y < 3.5f || segment.radius <= thickest) continue;
      thickest = segment.radius;
      off = std::hypot(segment.end.x, segment.end.z);
    }
    return std::pair(off, thickest);
  };
  const auto [straight, trunk] = largest_offset(0);
  const auto [swaying, other] = largest_offset(0.15f);
  CHECK(straight < 0.25f);
  CHECK(swaying > straight + 0.15f);
  CHECK(other > 0.6f * trunk);
}

}  // namespace
}  // namespace panicle::particles
