#include "models/particles/polish.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "foundation/mathematics.hpp"
#include "models/particles/particle_system.hpp"
#include "models/particles/scatter.hpp"
#include "shapes.hpp"

using namespace panicle;
using namespace panicle::particles;

namespace {

struct Run {
  float spacing;
  Trails trails;
};

const Straight petiole({0, -1.2f, 0});

Run run(std::uint32_t count, bool flat) {
  const Round region(flat);
  const float spacing = spacing_of(region, count);
  const auto starts = scatter(region, Pattern::blue, count, spacing, 2);
  ParticleSystem crowd(starts, 1, petiole, {.step = 0.35f * spacing, .merge = 0.7f * spacing});
  crowd.run();
  return {spacing, crowd.trails()};
}

// Degrees that a trail turns at a place that one leads to, in the mean.
float mean_turn(const Trails& trails) {
  std::vector<int> leading(trails.size(), 0);
  for (std::size_t i = 1; i < trails.size(); ++i) ++leading[static_cast<std::size_t>(trails.next[i])];
  float sum = 0, count = 0;
  for (std::size_t i = 1; i < trails.size(); ++i) {
    const auto at = static_cast<std::size_t>(trails.next[i]);
    if (at == 0 || leading[at] != 1) continue;
    const glm::vec3 in = trails.places[at] - trails.places[i];
    const glm::vec3 out = trails.places[static_cast<std::size_t>(trails.next[at])] - trails.places[at];
    const float lengths = glm::length(in) * glm::length(out);
    if (!(lengths > 0)) continue;
    sum += arc_cosine(glm::dot(in, out) / lengths) * 180 / pi;
    ++count;
  }
  return sum / count;
}

// Where trails fork and how much energy passes there, by how many starts lie beyond.
std::vector<double> forks(const Trails& trails) {
  std::vector<int> leading(trails.size(), 0);
  for (std::size_t i = 1; i < trails.size(); ++i) ++leading[static_cast<std::size_t>(trails.next[i])];
  std::vector<double> found;
  for (std::size_t i = 0; i < trails.size(); ++i)
    if (leading[i] > 1) found.push_back(trails.energy[i]);
  std::sort(found.begin(), found.end());
  return found;
}

// Starts of particles whose place no other particle passed.
std::map<std::int32_t, glm::vec3> ends_of(const Trails& trails) {
  std::map<std::int32_t, glm::vec3> ends;
  for (std::size_t i = 0; i < trails.size(); ++i)
    if (trails.particle[i] >= 0 && trails.energy[i] == 1) ends[trails.particle[i]] = trails.places[i];
  return ends;
}

std::size_t starts_of(const Trails& trails) {
  return static_cast<std::size_t>(
      std::count_if(trails.particle.begin(), trails.particle.end(), [](std::int32_t p) { return p >= 0; }));
}

}  // namespace

TEST_CASE("smoothing removes turns from trails and keeps the target, ends and the tree") {
  for (const bool flat : {true, false}) {
    Run before = run(800, flat);
    Trails after = before.trails;
    smooth(after, petiole);
    CHECK(mean_turn(before.trails) > 15);
    CHECK(mean_turn(after) < 8);
    CHECK(after.places[0] == petiole.target());
    CHECK(ends_of(after) == ends_of(before.trails));
    CHECK(after.next == before.trails.next);
  }
}

TEST_CASE("smoothing moves a place halfway to the mean of its neighbours, by their energy") {
  // The middle of three, and of a fork of 1 and 3.
  Trails trails{.places = {{0, 0, 0}, {0, 1, 0}, {-1, 2, 0}, {1, 2, 0}},
                .next = {-1, 0, 1, 1},
                .energy = {4, 4, 1, 3},
                .born = {0, 0, 0, 0},
                .particle = {-1, -1, 0, 1}};
  smooth(trails, petiole);
  // The fixed point: y = (0 + 2) / 2, x = (0 + 0.5) / 2.
  CHECK(trails.places[1].y == doctest::Approx(1));
  CHECK(trails.places[1].x == doctest::Approx(0.25));
}

TEST_CASE("a share of a pass moves a place that share of the way, and places with more energy move more") {
  const auto bent = [](double energy) {
    return Trails{.places = {{0, 0, 0}, {0, 1, 0}, {1, 2, 0}, {0, 3, 0}, {5, 0, 0}},
                  .next = {-1, 0, 1, 2, 0},
                  .energy = {4, energy, energy, energy, 4 - energy},
                  .born = {0, 0, 0, 0, 0},
                  .particle = {-1, -1, -1, 0, 1}};
  };
  // 17.5 passes with all the energy, 10 with a quarter of it.
  Trails some = bent(4), less = bent(1);
  smooth(some, petiole, 0.5f / 17.5f);
  smooth(less, petiole, 0.5f / 17.5f);
  CHECK(some.places[1].x == doctest::Approx(0.25));
  CHECK(some.places[2].x == doctest::Approx(1 - 0.5 * (1 - 0.125)));
  CHECK(less.places[1].x == doctest::Approx(0.25 * 10 / 17.5));
}

TEST_CASE("no place is moved out of the open region") {
  const Walled guide({0.5f, -0.8f, 0});
  Trails trails{.places = {{0.5f, -0.8f, 0}, {0.02f, -0.5f, 0}, {0, 0.52f, 0}, {-0.02f, -0.5f, 0}},
                .next = {-1, 0, 1, 2},
                .energy = {1, 1, 1, 1},
                .born = {0, 0, 0, 0},
                .particle = {-1, -1, -1, 0}};
  smooth(trails, guide);
  for (const glm::vec3& place : trails.places) CHECK(guide.open(place));
  CHECK(trails.places[2].y > 0.5f);
}

TEST_CASE("simplifying keeps forks, starts and energies, and every place within the tolerance") {
  for (const bool flat : {true, false}) {
    Run grown = run(800, flat);
    smooth(grown.trails, petiole);
    const float tolerance = 0.05f * grown.spacing;
    const Trails left = simplified(grown.trails, tolerance);
    CHECK(left.size() < 0.6 * static_cast<double>(grown.trails.size()));
    CHECK(forks(left) == forks(grown.trails));
    CHECK(ends_of(left) == ends_of(grown.trails));
    CHECK(starts_of(left) == starts_of(grown.trails));
    CHECK(left.energy[0] == grown.trails.energy[0]);
    float farthest = 0;
    for (const glm::vec3& place : grown.trails.places) {
      float nearest = 1e9f;
      for (std::size_t i = 1; i < left.size(); ++i) {
        const glm::vec3 from = left.places[i], way = left.places[static_cast<std::size_t>(left.next[i])] - from;
        const float square = glm::dot(way, way);
        const float at = square > 0 ? std::clamp(glm::dot(place - from, way) / square, 0.0f, 1.0f) : 0;
        nearest = std::min(nearest, glm::distance(place, from + at * way));
      }
      farthest = std::max(farthest, nearest);
    }
    CHECK(farthest <= 1.001f * tolerance);
    for (std::size_t i = 1; i < left.size(); ++i) {
      REQUIRE(left.next[i] >= 0);
      CHECK(static_cast<std::size_t>(left.next[i]) < i);
    }
  }
}

TEST_CASE("a straight trail is two places at any tolerance") {
  Trails trails;
  for (int i = 0; i < 50; ++i) {
    trails.places.push_back({0, static_cast<float>(i), 0});
    trails.next.push_back(i - 1);
    trails.energy.push_back(1);
    trails.born.push_back(0);
    trails.particle.push_back(i == 49 ? 0 : -1);
  }
  CHECK(simplified(trails, 1e-4f).size() == 2);
  trails.places[20].x = 1;
  CHECK(simplified(trails, 0.5f).size() == 5);  // the corner, and both feet of it
}
