#include "models/particles/trunk.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "models/particles/gather.hpp"
#include "models/particles/particle_system.hpp"
#include "models/particles/scatter.hpp"
#include "spatial/solid.hpp"

namespace panicle::particles {
namespace {

TEST_CASE("particles aim at the axis below them, as much lower as they are away") {
  const Trunk trunk({1, 0, 2}, {.slant = 0.5f, .ahead = 0.1f});
  CHECK(trunk.aim({3, 5, 2}) == glm::vec3(1, 4, 2));
  CHECK(trunk.aim({1, 5, 2}).y == doctest::Approx(4.9f));  // on the axis: by the looking distance
  CHECK(trunk.aim({3, 0.5f, 2}) == glm::vec3(1, 0, 2));    // never below the target
  CHECK(trunk.way({3, 5, 2}) == doctest::Approx(std::sqrt(5.0f) + 4));
}

TEST_CASE("root particles aim at the axis above them") {
  const Trunk trunk({0, 0, 0}, {.slant = 1, .ahead = 0.1f, .way = 1});
  CHECK(trunk.aim({2, -5, 0}) == glm::vec3(0, -3, 0));
  CHECK(trunk.aim({2, -1, 0}) == glm::vec3(0, 0, 0));
}

TEST_CASE("no particle comes to the bole, except those beside it") {
  const Trunk trunk({0, 0, 0}, {.slant = 2, .ahead = 0.1f, .bole = 1});
  CHECK(trunk.aim({2, 3, 0}) == glm::vec3(0, 1, 0));
  CHECK(trunk.aim({2, 0.5f, 0}) == glm::vec3(0, 0, 0));
  CHECK(trunk.aim({0, 1, 0}).y == doctest::Approx(0.9f));
  CHECK(trunk.aim({0, 0.05f, 0}) == glm::vec3(0, 0, 0));
}

TEST_CASE("ways bend more farther from the axis, and end at the target") {
  TrunkHabit habit{.slant = 1, .ahead = 0.1f, .bend = {0, 0.7f, 0}, .reach = 2};
  const Trunk bent({0, 0, 0}, habit);
  const auto rise = [&](float x) {
    const glm::vec3 p(x, 5, 0), way = bent.aim(p) - p;
    return way.y / glm::length(way);
  };
  CHECK(rise(2) > rise(1));
  CHECK(rise(1) > rise(0.2f));
  CHECK(rise(0.2f) > -0.72f);
  CHECK(rise(4) == doctest::Approx(rise(2)));
  // The strongest bends allowed, to every side.
  for (const glm::vec3& way : {glm::vec3(0, 2, 0), glm::vec3(0, -2, 0), glm::vec3(2, 0, 0), glm::vec3(-1, 1, 1)}) {
    habit.bend = way;
    const Trunk guide({0, 0, 0}, habit);
    const std::vector<glm::vec3> starts{{2, 4, 0}, {-2, 4, 0}, {0, 5, 2}, {0, 5, -2}};
    ParticleSystem crowd(starts, 1, guide, {.step = 0.05f, .merge = 0.1f, .pull = 1});
    crowd.run();
    CHECK(crowd.arrived() == 4);
    CHECK(crowd.stragglers() == 0);
  }
}

TEST_CASE("a way leads out of the crown downwards alone") {
  const Solid crown(box({-1, 2, -1}, {1, 4, 1}));
  const Trunk trunk({0, 0, 0}, {.ahead = 0.1f}, &crown);
  CHECK(trunk.passes({0, 2.1f, 0}, {0, 1.9f, 0}));
  CHECK(trunk.passes({0, 2, 0}, {0, 3, 0}));
  CHECK_FALSE(trunk.passes({0, 3.9f, 0}, {0, 4.1f, 0}));
  CHECK_FALSE(trunk.passes({0, 1, 0}, {0, 1.1f, 0}));
  CHECK_FALSE(trunk.passes({0, 0.1f, 0}, {0, -0.1f, 0}));  // the ground
  CHECK_FALSE(trunk.passes({0, -0.1f, 0}, {0, -0.2f, 0}));
  const Trunk root({0, 5, 0}, {.ahead = 0.1f, .way = 1}, &crown);
  CHECK(root.passes({0, 3.9f, 0}, {0, 4.1f, 0}));
  CHECK_FALSE(root.passes({0, 2.1f, 0}, {0, 1.9f, 0}));
}

TEST_CASE("particles leave the crown downwards alone, even if their ways bend up") {
  const Solid crown(box({-1, 2.5f, -1}, {1, 3.5f, 1}));
  const float spacing = spacing_of(crown, 400);
  const std::vector<glm::vec3> starts = scatter(crown, Pattern::blue, 400, spacing, 3);
  const TrunkHabit habit{.slant = 0.2f, .ahead = 2 * spacing, .bend = {0, 0.9f, 0}, .reach = 0.3f};
  const auto above = [&](const Region* outer) {
    const Trunk guide({0, 0, 0}, habit, outer);
    ParticleSystem crowd(starts, 1, guide, {.step = 0.35f * spacing, .merge = 0.7f * spacing, .pull = 1});
    crowd.run();
    const Trails trails = crowd.trails();
    return std::count_if(trails.places.begin(), trails.places.end(),
                         [&](const glm::vec3& place) { return place.y > crown.high().y; });
  };
  CHECK(above(&crown) == 0);
  CHECK(above(nullptr) > 20);
}

TEST_CASE("obstacles hide places behind them, and particles go round") {
  const std::vector<Box> wall{{{0.5f, -1, -2}, {0.7f, 4, 2}}};
  const Obstacles obstacles(wall, 0.02f, 0, 100);
  CHECK(obstacles.contains({0.6f, 1, 0}));
  CHECK_FALSE(obstacles.contains({0.8f, 1, 0}));
  CHECK(obstacles.between({1, 1, 0}, {0, 1, 0}));
  CHECK_FALSE(obstacles.between({1, 1, 0}, {1, 5, 0}));
  CHECK_FALSE(obstacles.between({1, 5, 0}, {0, 5, 0}));
  CHECK_FALSE(obstacles.between({0.72f, 1, 0}, {0.72f, 1, 1}));  // along a face
  CHECK(obstacles.between({0.6f, 1, 0}, {0.6f, 1, 0.1f}));       // in it
  for (const glm::vec3& corner : obstacles.corners()) {
    CHECK_FALSE(obstacles.contains(corner));
    CHECK(corner.y >= 0);
  }
  const Trunk trunk({0, 0, 0}, {.slant = 1, .ahead = 0.1f}, nullptr, &obstacles);
  const glm::vec3 behind(1.5f, 3, 0);
  CHECK(trunk.reaches(behind));
  CHECK_FALSE(trunk.reaches({0.6f, 1, 0}));
  CHECK(trunk.way(behind) > 3.6f);
  // Walks there without crossing it.
  std::vector<glm::vec3> starts;
  for (float z = -1.8f; z < 2; z += 0.4f)
    for (float y = 1; y < 4.5f; y += 0.5f) starts.emplace_back(1.5f, y, z);
  ParticleSystem crowd(starts, 1, trunk, {.step = 0.05f, .merge = 0.1f, .pull = 1});
  crowd.run();
  const Trails trails = crowd.trails();
  const Obstacles bare(wall, 0, 0, 100);
  for (std::size_t i = 1; i < trails.size(); ++i)
    CHECK_FALSE(bare.between(trails.places[i], trails.places[static_cast<std::size_t>(trails.next[i])]));
  CHECK(crowd.arrived() == static_cast<double>(starts.size()));
}

TEST_CASE("places without a way out are unreachable") {
  // A chimney: four walls and a lid.
  const std::vector<Box> chimney{{{2, 0, -1}, {2.2f, 4, 1}},
                                 {{4, 0, -1}, {4.2f, 4, 1}},
                                 {{2, 0, -1.2f}, {4.2f, 4, -1}},
                                 {{2, 0, 1}, {4.2f, 4, 1.2f}},
                                 {{2, 4, -1.2f}, {4.2f, 4.2f, 1.2f}}};
  const Obstacles obstacles(chimney, 0.02f, 0, 100);
  const Trunk trunk({0, 0, 0}, {.ahead = 0.1f}, nullptr, &obstacles);
  CHECK_FALSE(trunk.reaches({3, 2, 0}));
  CHECK(trunk.reaches({5, 2, 0}));
}

TEST_CASE("trails down one axis become one trunk, with all that arrives") {
  // Two trails side by side on the axis, and a place that a detour off it leaves empty.
  Trails trails;
  trails.places = {{0, 0, 0}, {0, 1, 0}, {0.01f, 1.5f, 0}, {0, 2, 0}, {0.01f, 2.5f, 0}, {1, 3, 0}, {-1, 4, 0}};
  trails.next = {-1, 0, 0, 1, 2, 3, 4};
  trails.energy = {3, 1, 2, 1, 2, 1, 2};
  trails.born = {9, 7, 8, 5, 6, 1, 1};
  trails.particle = {-1, -1, -1, -1, -1, 0, 1};
  const Trails one = gathered(trails, Axis(trails.places[0]), Straight({0, 0, 0}), 0.1f, 0.5f);
  REQUIRE(one.size() == 7);
  CHECK(one.energy[0] == 3);
  std::size_t at_target = 0;
  for (std::size_t i = 1; i < one.size(); ++i) {
    CHECK(one.next[i] < static_cast<std::int32_t>(i));
    const std::size_t next = static_cast<std::size_t>(one.next[i]);
    at_target += next == 0;
    CHECK(one.places[next].y < one.places[i].y);
    if (one.places[i].y == 1) CHECK(one.energy[i] == 3);
    if (one.places[i].y == 2.5f) CHECK(one.energy[i] == 2);
    if (one.places[i].y == 2) {
      CHECK(one.energy[i] == 3);
      CHECK(one.born[i] == 5);
    }
    // Left by the particle that came by before its own.
    if (one.places[i].y == 1.5f) CHECK(one.born[i] == 6);
  }
  CHECK(one.born[0] == 8);
  CHECK(at_target == 1);
}

TEST_CASE("an excursion off the axis without energy is left out") {
  Trails trails;
  trails.places = {{0, 0, 0}, {0, 1, 0}, {0.5f, 2, 0}, {0, 3, 0}, {1, 4, 0}};
  trails.next = {-1, 0, 1, 2, 3};
  trails.energy = {1, 1, 1, 1, 1};
  trails.born = {5, 4, 3, 2, 1};
  trails.particle = {-1, -1, -1, -1, 0};
  const Trails one = gathered(trails, Axis(trails.places[0]), Straight({0, 0, 0}), 0.1f, 0.5f);
  REQUIRE(one.size() == 4);
  for (const glm::vec3& place : one.places) CHECK(place.x != 0.5f);
}

TEST_CASE("beyond an obstacle on the axis trails are one line that goes round as its particles went") {
  const std::vector<Box> boxes{{{-0.3f, 1.4f, -0.3f}, {0.3f, 1.6f, 0.3f}}};
  const Obstacles obstacles(boxes, 0, 0, 100);
  const Trunk guide({0, 0, 0}, {.ahead = 0.1f}, nullptr, &obstacles);
  // Two trails side by side above it, each round it on a side of its own.
  Trails trails;
  trails.places = {{0, 0, 0}, {0, 1, 0},        {0.01f, 0.8f, 0}, {0.5f, 1.5f, 0}, {-0.5f, 1.5f, 0},
                   {0, 2, 0}, {0.01f, 2.2f, 0}, {1, 3, 0},        {-1, 3, 0}};
  trails.next = {-1, 0, 0, 1, 2, 3, 4, 5, 6};
  trails.energy = {2, 1, 1, 1, 1, 1, 1, 1, 1};
  trails.born = {9, 7, 7, 5, 5, 3, 3, 1, 1};
  trails.particle = {-1, -1, -1, -1, -1, -1, -1, 0, 1};
  const Trails one = gathered(trails, Axis(trails.places[0]), guide, 0.1f, 0.5f);
  REQUIRE(one.size() == 8);
  for (std::size_t i = 1; i < one.size(); ++i) {
    const auto next = static_cast<std::size_t>(one.next[i]);
    CHECK(guide.sees(one.places[i], one.places[next]));
    CHECK(one.places[i].x != -0.5f);
    if (one.places[i].x == 0.5f) CHECK(one.energy[i] == 2);
  }
}

}  // namespace
}  // namespace panicle::particles
