// Twigs that hang, branches that wander.
#include "models/particles/twig_shape.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "models/particles/polish.hpp"
#include "models/particles/space_growing.hpp"
#include "models/particles/trunk.hpp"
#include "models/tree/crown.hpp"
#include "spatial/solid.hpp"

namespace panicle::particles {
namespace {

const Obstacles none({}, {}, 0, 0, 100);

// A limb to the right, and a twig that goes on from it level, four pieces long.
Trails limb_with_twig() {
  Trails trails{.places = {{0, 0, 0}, {0, 3, 0}, {1, 3, 0}},
                .next = {-1, 0, 1},
                .energy = {5, 5, 5},
                .born = {20, 10, 8},
                .particle = {-1, -1, -1}};
  const auto add = [&](const glm::vec3& place, std::int32_t next, double energy, std::int32_t particle) {
    trails.places.push_back(place);
    trails.next.push_back(next);
    trails.energy.push_back(energy);
    trails.born.push_back(0);
    trails.particle.push_back(particle);
  };
  for (int k = 0; k < 4; ++k) add({1, 4 + k, 0}, 2, 1, k);
  for (int k = 1; k <= 4; ++k)
    add({1 + 0.5f * static_cast<float>(k), 3, 0}, k == 1 ? 2 : 6 + k - 1, 1, k == 4 ? 4 : -1);
  return trails;
}

TEST_CASE("a twig hangs more farther from its parent, and keeps its length") {
  const Solid crown(box({-5, 0, -5}, {5, 9, 5}));
  const Trunk guide({0, 0, 0}, {.ahead = 0.1f}, &crown, &none);
  const Trails before = limb_with_twig();
  Trails trails = before;
  hang_twigs(trails, guide, crown, crown, {.weep = 1, .weep_tips = 3}, 1);
  for (std::size_t i = 0; i < 3; ++i) CHECK(trails.places[i] == before.places[i]);
  float steepest = 0;
  for (std::size_t i = 7; i < trails.size(); ++i) {
    const auto next = static_cast<std::size_t>(trails.next[i]);
    const glm::vec3 way = trails.places[i] - trails.places[next];
    CHECK(glm::length(way) == doctest::Approx(0.5f));
    CHECK(way.y <= steepest);
    if (i == 7) CHECK(way.y > -0.25f);  // no kink where it leaves the branch
    steepest = way.y;
  }
  CHECK(steepest < -0.3f);
  CHECK(trails.energy == before.energy);
  CHECK(trails.next == before.next);
  Trails half = before;
  hang_twigs(half, guide, crown, crown, {.weep = 0.5f, .weep_tips = 3}, 1);
  CHECK(half.places.back().y > trails.places.back().y + 0.2f);
  // A vertical twig has no side to fall to, and twigs with more tips stay.
  for (std::size_t i = 3; i < 7; ++i) CHECK(trails.places[i].x == before.places[i].x);
  Trails heavy = before;
  hang_twigs(heavy, guide, crown, crown, {.weep = 1, .weep_tips = 1}, 1);
  CHECK(heavy.places == before.places);
}

TEST_CASE("a twig with no room below stays as it grew") {
  const Solid crown(box({-5, 2.9f, -5}, {5, 9, 5}));
  const Trunk guide({0, 0, 0}, {.ahead = 0.1f}, &crown, &none);
  const Trails before = limb_with_twig();
  Trails trails = before;
  hang_twigs(trails, guide, crown, crown, {.weep = 1, .weep_tips = 3}, 1);
  for (std::size_t i = 7; i < trails.size(); ++i) CHECK(glm::distance(trails.places[i], before.places[i]) < 1e-5f);
}

TEST_CASE("hanging twigs of a tree point down, and its particles stay between the boundaries") {
  const auto steepness = [](float weep) {
    const Plant plant =
        grow_tree({.parameters = {{"particles", 1500}, {"inner", 0.5f}, {"weep", weep}, {"sway", 0}}, .seed = 4});
    check_sound(plant, 1);
    const auto crowns = tree::make_crowns({.inner = 0.5f}, {}, {});
    float sum = 0;
    for (const std::size_t tip : tips_of(plant)) {
      const Segment& twig = plant.segments[tip];
      CHECK(crowns.outer.contains(twig.end));
      CHECK_FALSE(crowns.inner.contains(twig.end));
      sum += glm::normalize(twig.end - twig.start).y;
    }
    const float spacing = std::cbrt(6 * 6 * 6 * 0.5f / 1500);
    for (const Segment& segment : plant.segments)
      if (!crowns.outer.contains(segment.end) && !crowns.outer.contains(segment.start))
        CHECK(segment.start.y <= segment.end.y + 0.5f * spacing);
    return sum / static_cast<float>(tips_of(plant).size());
  };
  CHECK(steepness(1) < steepness(0) - 0.35f);
}

TEST_CASE("branches wander within the crown, by the given length; ends and the way to the target stay") {
  const Solid crown(box({-5, 0, -5}, {5, 9, 5}));
  const Trunk guide({0, 0, 0}, {.ahead = 0.1f}, &crown, &none);
  Trails trails = divided(limb_with_twig(), 0.1f, 0, 100, 0.1f);
  const Trails before = trails;
  wander_branches(trails, guide, crown, 0.2f, 0.5f, 7);
  float farthest = 0;
  for (std::size_t i = 0; i < trails.size(); ++i) {
    const float off = glm::distance(trails.places[i], before.places[i]);
    CHECK(off < 0.2f * std::sqrt(3.0f));
    if (trails.particle[i] >= 0 || trails.next[i] <= 0) CHECK(off == 0);
    farthest = std::max(farthest, off);
  }
  CHECK(farthest > 0.05f);
  // No twig leaves a crown that it fills.
  const Solid flat(box({-5, 0, -5}, {5, 3.01f, 5}));
  Trails held = before;
  wander_branches(held, guide, flat, 0.2f, 0.5f, 7);
  for (std::size_t i = 0; i < held.size(); ++i)
    if (flat.contains(before.places[i])) CHECK(flat.contains(held.places[i]));
}

TEST_CASE("wandering twigs do not go where an obstacle hides them") {
  const std::vector<float> wall{0.8f, 0, -2.5f, 1.1f, 6, 2.5f, -2, 3, -2, -1.5f, 5, 2};
  const Plant plant =
      grow_tree({.parameters = {{"particles", 1200}, {"inner", 0.3f}, {"crook", 1}, {"weep", 1}}, .obstacles = wall});
  check_sound(plant, 1);
  const std::vector<Box> boxes{{{0.8f, 0, -2.5f}, {1.1f, 6, 2.5f}}, {{-2, 3, -2}, {-1.5f, 5, 2}}};
  const Obstacles obstacles(boxes, 0, 0, 100);
  for (const Segment& segment : plant.segments) CHECK_FALSE(obstacles.between(segment.start, segment.end));
}

TEST_CASE("divided trails have no long piece but to the target, and run through it evenly") {
  const Trails whole = limb_with_twig();
  const Trails trails = divided(whole, 0.3f, 0, 100, 0.1f);
  CHECK(trails.size() > 2 * whole.size());
  for (std::size_t i = 1; i < trails.size(); ++i) {
    const auto next = static_cast<std::size_t>(trails.next[i]);
    REQUIRE(next < i);
    CHECK(trails.energy[i] <= trails.energy[next]);
    if (next == 0) continue;
    CHECK(glm::distance(trails.places[i], trails.places[next]) <= 0.3f + 1e-4f);
  }
  CHECK(std::count_if(trails.particle.begin(), trails.particle.end(), [](std::int32_t p) { return p >= 0; }) == 5);
  CHECK(divided(whole, 0.3f, 0, 0.5, 0.1f).size() == whole.size());
  CHECK(divided(whole, 0.3f, 6, 100, 0.1f).size() == whole.size());
  const Trails one = divided({.places = {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}},
                              .next = {-1, 0, 1},
                              .energy = {1, 1, 1},
                              .born = {30, 20, 4},
                              .particle = {-1, -1, 0}},
                             0.3f, 0, 100, 0.1f);
  CHECK(one.born == std::vector<std::uint32_t>{30, 20, 16, 12, 8, 4});
  CHECK(one.places[3] == glm::vec3(0, 1, 0.5f));
}

}  // namespace
}  // namespace panicle::particles
