#include "models/particles/venation.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "models/particles/particle_system.hpp"
#include "models/particles/polish.hpp"
#include "models/particles/scatter.hpp"

using namespace panicle;
using namespace panicle::particles;

namespace {

// A square blade above its petiole.
const Outline& square() {
  static const Outline outline({{-0.5f, 0}, {0.5f, 0}, {0.5f, 1}, {-0.5f, 1}});
  return outline;
}

Ribs midrib() { return {{{0, 0, 0}, {0, 0.3f, 0}, {0, 0.6f, 0}, {0, 0.95f, 0}}, {-1, 0, 1, 2}}; }

}  // namespace

TEST_CASE("particles aim at the midrib, the farther below their foot the farther off they are") {
  const Ribs ribs = midrib();
  const Venation guide(square(), ribs, 1, 0.02f);
  CHECK(guide.target() == glm::vec3(0, 0, 0));
  const glm::vec3 near = guide.aim({0.1f, 0.8f, 0}), far = guide.aim({0.4f, 0.8f, 0});
  CHECK(near.x == doctest::Approx(0));
  CHECK(near.y == doctest::Approx(0.7));
  CHECK(far.y == doctest::Approx(0.4));
  // On the rib the aim is down it; at a slant of 0 at the foot itself, or at the least looking distance.
  CHECK(guide.aim({0, 0.5f, 0}).y == doctest::Approx(0.46));
  CHECK(Venation(square(), ribs, 0, 0.001f).aim({0.4f, 0.8f, 0}).y == doctest::Approx(0.798));
  CHECK(guide.way({0.2f, 0.8f, 0}) == doctest::Approx(1.0));
}

TEST_CASE("without ribs particles aim at the petiole, round corners where needed") {
  const Outline hook({{0, 0}, {1, 0}, {1, 1}, {0.2f, 1}, {0.2f, 0.8f}, {0.8f, 0.8f}, {0.8f, 0.2f}, {0, 0.2f}});
  const Ribs petiole{{{0, 0.1f, 0}}, {-1}};
  const Venation guide(hook, petiole, 0.8f, 0.02f);
  CHECK(guide.aim({0.5f, 0.1f, 0}) == petiole.places[0]);
  const glm::vec3 far(0.3f, 0.9f, 0), corner = guide.aim(far);
  CHECK(corner != petiole.places[0]);
  CHECK(hook.holds(far, corner));
  CHECK(guide.way(far) > 1.9f);
  CHECK(guide.way(far) < 2.4f);
}

TEST_CASE("trails of a bent blade stay in it, at once and once they are polished") {
  const Outline hook({{0, 0}, {1, 0}, {1, 1}, {0.2f, 1}, {0.2f, 0.8f}, {0.8f, 0.8f}, {0.8f, 0.2f}, {0, 0.2f}});
  const Ribs petiole{{{0, 0.1f, 0}}, {-1}};
  const auto starts = scatter(hook, Pattern::blue, 600, spacing_of(hook, 600), 4);
  const float spacing = spacing_of(hook, 600);
  const Venation guide(hook, petiole, 0.8f, spacing);
  ParticleSystem crowd(starts, 1, guide, {.step = 0.35f * spacing, .merge = 0.7f * spacing, .join = 0.25f * spacing});
  crowd.run();
  CHECK(crowd.stragglers() == 0);
  Trails trails = crowd.trails();
  const auto check = [&] {
    for (const glm::vec3& place : trails.places)
      CHECK((hook.contains(place) || hook.distance(place) <= 0.35f * spacing));
  };
  check();
  smooth(trails, guide);
  check();
}

TEST_CASE("trails along a rib are moved onto it, the heaviest straight past where another leaves") {
  // A trail down beside the midrib, and a light one that comes in along a side rib.
  const Ribs ribs{{{0, 0, 0}, {0, 0.4f, 0}, {0, 0.8f, 0}, {0.3f, 0.7f, 0}}, {-1, 0, 1, 1}};
  const RibGrid grid(ribs, {-1, 0, 0}, {1, 1, 0});
  Trails trails;
  trails.places = {{0, 0, 0},    {0.01f, 0.2f, 0}, {0.02f, 0.41f, 0}, {0.01f, 0.6f, 0},
                   {0, 0.8f, 0}, {0.2f, 0.61f, 0}, {0.3f, 0.75f, 0}};
  trails.next = {-1, 0, 1, 2, 3, 2, 5};
  trails.energy = {100, 100, 100, 70, 70, 30, 30};
  trails.born.assign(7, 0);
  trails.particle = {-1, -1, -1, -1, 0, -1, 1};
  const Straight guide({0, 0, 0});
  move_onto_ribs(trails, grid, guide, 0.06f);
  CHECK(std::fabs(trails.places[1].x) < 2e-4f);
  // The side rib is as near, but the midrib goes on.
  CHECK(std::fabs(trails.places[2].x) < 2e-4f);
  CHECK(std::fabs(trails.places[3].x) < 2e-4f);
  CHECK(grid.nearest(trails.places[5]).distance < 1e-3f);
  // Ends stay.
  CHECK(trails.places[4] == glm::vec3(0, 0.8f, 0));
  CHECK(trails.places[6] == glm::vec3(0.3f, 0.75f, 0));
}

TEST_CASE("trails drawn off a rib are moved back onto it, where the way is free") {
  const Ribs ribs{{{0, 0, 0}, {0, 1, 0}}, {-1, 0}};
  const RibGrid grid(ribs, {-1, 0, 0}, {1, 1, 0});
  const auto bumped = [] {
    Trails trails;
    trails.places = {{0, 0, 0},    {0, 0.3f, 0},     {0.05f, 0.5f, 0}, {0, 0.7f, 0},
                     {0, 0.9f, 0}, {0.05f, 0.6f, 0}, {0.1f, 0.7f, 0}};
    trails.next = {-1, 0, 1, 2, 3, 3, 5};
    trails.energy = {100, 100, 100, 90, 70, 20, 20};
    trails.born.assign(7, 0);
    trails.particle = {-1, -1, -1, -1, 0, -1, 1};
    return trails;
  };
  Trails trails = bumped();
  move_onto_ribs(trails, grid, Straight({0, 0, 0}), 0.04f);
  CHECK(std::fabs(trails.places[2].x) < 0.015f);
  CHECK(trails.places[5].x == 0.05f);  // a place that comes in from the side is as far off, and stays
  class Blind final : public Guide {
   public:
    Blind() : Guide({0, 0, 0}) {}
    glm::vec3 aim(const glm::vec3&) const override { return target(); }
    bool sees(const glm::vec3&, const glm::vec3&) const override { return false; }
  };
  Trails hidden = bumped();
  move_onto_ribs(hidden, grid, Blind(), 0.04f);
  CHECK(hidden.places[2].x == 0.05f);
}
