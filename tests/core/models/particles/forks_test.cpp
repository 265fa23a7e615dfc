#include "models/particles/forks.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "models/particles/boundary.hpp"
#include "models/particles/particle_system.hpp"
#include "models/particles/polish.hpp"
#include "models/particles/scatter.hpp"
#include "models/particles/space_growing.hpp"
#include "models/particles/trunk.hpp"
#include "models/tree/measures/measures.generated.hpp"

namespace panicle::particles {
namespace {

// Two that met face to face, a way above the target.
Trails face_to_face() {
  return {.places = {{0, 0, 0}, {0, 1, 0}, {0, 4, 0}, {-1, 4, 0}, {1, 4, 0}},
          .next = {-1, 0, 1, 2, 2},
          .energy = {2, 2, 2, 1, 1},
          .born = {9, 8, 5, 0, 0},
          .particle = {-1, -1, -1, 0, 1}};
}

float angle_at(const Trails& trails, std::size_t fork) {
  const glm::vec3 one = glm::normalize(trails.places[3] - trails.places[fork]),
                  other = glm::normalize(trails.places[4] - trails.places[fork]);
  return std::acos(glm::dot(one, other)) * 57.29578f;
}

TEST_CASE("particles that met face to face have a fork, no farther away than the given distance") {
  Trails trails = face_to_face();
  const Straight guide({0, 0, 0});
  narrow_forks(trails, guide, 0.05f, 2);
  CHECK(angle_at(trails, 2) < 65);
  CHECK(angle_at(trails, 2) > 25);
  CHECK(trails.places[0] == glm::vec3(0));
  CHECK(trails.places[1] == glm::vec3(0, 1, 0));
  CHECK(trails.places[3] == glm::vec3(-1, 4, 0));
  Trails held = face_to_face();
  narrow_forks(held, guide, 0.05f, 0.3f);
  CHECK(glm::distance(held.places[2], {0, 4, 0}) == doctest::Approx(0.3f));
}

TEST_CASE("two places that are drawn towards each other never pass each other") {
  // The trail comes up from below to the second, down to the first, and goes up to the target.
  Trails trails{.places = {{0, 9, 0}, {0, 8, 0}, {0, 1, 0}, {0, 2, 0}, {0.1f, -9, 0}, {-0.1f, -9, 0}},
                .next = {-1, 0, 1, 2, 3, 3},
                .energy = {2, 2, 2, 2, 1, 1},
                .born = {9, 8, 7, 6, 0, 0},
                .particle = {-1, -1, -1, -1, 0, 1}};
  narrow_forks(trails, Straight({0, 9, 0}), 0.05f, 9);
  CHECK(trails.places[3].y - trails.places[2].y == doctest::Approx(0.05f).epsilon(0.01));
}

TEST_CASE("forks do not move to places where an obstacle hides their twigs") {
  // The twigs run along the top of a box, beside which the fork would be.
  const std::vector<Box> boxes{{{-0.9f, 2, -1}, {-0.1f, 3.9f, 1}}};
  const Obstacles obstacles(boxes, 0.01f, 0, 10);
  const Trunk guide(glm::vec3(0), {.ahead = 0.1f}, nullptr, &obstacles);
  Trails trails = face_to_face();
  narrow_forks(trails, guide, 0.05f, 2);
  for (std::size_t i = 1; i < trails.size(); ++i)
    CHECK_FALSE(obstacles.between(trails.places[i], trails.places[static_cast<std::size_t>(trails.next[i])]));
  CHECK(trails.places[2].y > 3.7f);
}

TEST_CASE("where a crown is waisted, forks draw no more of a trail out of it than the particles did") {
  const std::vector<glm::vec2> waist{{0.1f, 0}, {1, 0.15f}, {0.15f, 0.5f}, {0.9f, 0.8f}, {0.1f, 1}};
  const Solid crown(form_between(Form::spline, spline_through(waist), {}, {-3, 2, -3}, {3, 8, 3}));
  const auto [starts, spacing, extent] = scatter_all(crown, Pattern::blue, 600, 1);
  const Trunk guide(glm::vec3(0), {.ahead = 2 * spacing, .bole = 1}, &crown);
  ParticleSystem crowd(starts, 1, guide, {.step = 0.35f * spacing, .merge = 0.7f * spacing, .pull = 1});
  crowd.run();
  Trails trails = crowd.trails();
  smooth(trails, guide, 1);
  trails = simplified(trails, 0.08f * spacing);
  const auto ways_out = [&] {
    std::size_t count = 0;
    for (std::size_t i = 1; i < trails.size(); ++i)
      count += !guide.passes(trails.places[i], trails.places[static_cast<std::size_t>(trails.next[i])]);
    return count;
  };
  const std::size_t before = ways_out();
  narrow_forks(trails, guide, 0.05f * spacing, 0.45f * spacing);
  CHECK(ways_out() <= before);
}

TEST_CASE("a tree's forks are those of wood: 40 to 75° on average") {
  const Plant plant = grow_tree({.parameters = {{"particles", 3000}, {"pull", 0.8f}}, .outputs = "measures"});
  const float angle = plant.measures[static_cast<std::size_t>(tree::Measure::fork_angle)];
  CHECK(angle > 40);
  CHECK(angle < 75);
}

}  // namespace
}  // namespace panicle::particles
