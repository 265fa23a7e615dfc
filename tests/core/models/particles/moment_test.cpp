#include "models/particles/moment.hpp"

#include <doctest/doctest.h>

#include "models/particles/particle_system.hpp"
#include "models/particles/polish.hpp"
#include "models/particles/scatter.hpp"
#include "shapes.hpp"

using namespace panicle;
using namespace panicle::particles;

TEST_CASE("at the beginning all particles are at their starts, at the end all trails are complete") {
  const Round disc(true);
  const Straight guide({0, -1, 0});
  const auto starts = scatter(disc, Pattern::blue, 300, spacing_of(disc, 300), 3);
  ParticleSystem crowd(starts, 2, guide, {.step = 0.04f, .merge = 0.07f, .join = 0.02f});
  crowd.run();
  const Trails whole = crowd.trails(), trails = simplified(whole, 0.005f);

  const Trails young = at_moment(trails, 0, 0.04f);
  std::size_t on_their_way = 0;
  for (std::size_t i = 1; i < young.size(); ++i) {
    REQUIRE(young.next[i] == -1);
    CHECK(young.energy[i] == 2);
    CHECK(young.places[i] == starts[static_cast<std::size_t>(young.particle[i])]);
    ++on_their_way;
  }
  CHECK(on_their_way == starts.size());
  CHECK(young.energy[0] == 0);

  const Trails old = at_moment(trails, static_cast<float>(crowd.steps()), 0.04f);
  CHECK(old.places == trails.places);
  CHECK(old.energy == trails.energy);
}

TEST_CASE("in between, no energy is lost, trees keep their order and every particle moves on") {
  const Round disc(true);
  const Straight guide({0.3f, -1, 0});
  const auto starts = scatter(disc, Pattern::jittered, 200, spacing_of(disc, 200), 8);
  ParticleSystem crowd(starts, 1, guide, {.step = 0.05f, .merge = 0.09f});
  crowd.run();
  const Trails trails = simplified(crowd.trails(), 0.004f);
  float before = 0;
  double at_target = 0;
  for (float moment = 0; moment <= static_cast<float>(crowd.steps()); moment += 1.5f) {
    const Trails young = at_moment(trails, moment, 0.05f);
    double roots = 0;
    float length = 0;
    for (std::size_t i = 0; i < young.size(); ++i) {
      if (young.next[i] < 0) {
        roots += young.energy[i];
        continue;
      }
      REQUIRE(static_cast<std::size_t>(young.next[i]) < i);
      length += glm::distance(young.places[i], young.places[static_cast<std::size_t>(young.next[i])]);
    }
    CHECK(roots == static_cast<double>(starts.size()));
    CHECK(length >= before);
    CHECK(young.energy[0] >= at_target);
    before = length;
    at_target = young.energy[0];
  }
  CHECK(at_target > 0);
}

TEST_CASE("particles run evenly between places, independent of earlier queries") {
  // Two starts that meet at a fork after 4 steps and go on to the target.
  const Trails whole{.places = {{0, 0, 0}, {0, 2, 0}, {-1, 3, 0}, {1, 3, 0}},
                     .next = {-1, 0, 1, 1},
                     .energy = {3, 3, 1, 2},
                     .born = {8, 4, 0, 0},
                     .particle = {-1, -1, 0, 1}};
  const auto fronts = [&](float moment) {
    std::vector<glm::vec3> found;
    const Trails young = at_moment(whole, moment, 1);
    for (std::size_t i = 1; i < young.size(); ++i)
      if (young.next[i] < 0) found.push_back(young.places[i]);
    return found;
  };
  for (const float moment : {3.0f, 1.0f, 2.0f}) {
    const auto two = fronts(moment);
    REQUIRE(two.size() == 2);
    CHECK(two[0].x == doctest::Approx(-1 + moment / 4));
    CHECK(two[1].x == doctest::Approx(1 - moment / 4));
    CHECK(two[0].y == doctest::Approx(3 - moment / 4));
  }
  const auto one = fronts(4.5f);
  REQUIRE(one.size() == 1);
  CHECK(one[0].y == doctest::Approx(1.5f));
}

TEST_CASE("a timeline counts the steps in which a particle visibly moves") {
  // One arrives in 2 steps and another, which waited in between, in steps 5 and 6; the crowd ran on until 9.
  const Trails whole{.places = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}},
                     .next = {-1, 0, 1, 0, 3, 4},
                     .energy = {2, 1, 1, 1, 1, 1},
                     .born = {9, 1, 0, 6, 5, 2},
                     .particle = {-1, -1, 0, -1, -1, 1}};
  const Timeline timeline({&whole, 1}, 1);
  CHECK(timeline.steps() == 4);
  CHECK(timeline.moment(0) == 0);
  CHECK(timeline.moment(0.375f) == 1.5f);
  CHECK(timeline.moment(0.5f) == 5);
  CHECK(timeline.moment(0.875f) == 6.5f);
}
