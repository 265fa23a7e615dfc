// Particles of several targets: the target of each, and the notes about those without one.
#include "models/particles/wood.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "foundation/english.hpp"
#include "models/particles/space_growing.hpp"
#include "spatial/solid.hpp"

namespace panicle::particles {
namespace {

// Four walls and a lid about the place on the ground at x.
std::vector<float> hut(float x) {
  std::vector<float> boxes;
  const auto add = [&](float from, float low, float front, float to, float high, float back) {
    boxes.insert(boxes.end(), {x + from, low, front, x + to, high, back});
  };
  add(-1, 0, -1, -0.8f, 1, 1);
  add(0.8f, 0, -1, 1, 1, 1);
  add(-1, 0, -1, 1, 1, -0.8f);
  add(-1, 0, 0.8f, 1, 1, 1);
  add(-1, 1, -1, 1, 1.2f, 1);
  return boxes;
}

TEST_CASE("where the nearest target is unreachable, particles go to the nearest reachable one") {
  const Plant plant =
      grow_tree({.parameters = {{"particles", 600}}, .targets = {0, 0, 0, -6, 0, 0, 4, 0, 0}, .obstacles = hut(0)});
  check_sound(plant, 1);
  CHECK(plant.notes.empty());
  const auto arrived = column_in<float>(plant, "targets.energy");
  CHECK(arrived[0] == 0);
  CHECK(arrived[1] + arrived[2] == static_cast<float>(count_of(plant, "particles")));
  std::vector<float> root(plant.segments.size());
  for (std::size_t i = 0; i < root.size(); ++i) {
    const Segment& segment = plant.segments[i];
    root[i] = segment.parent < 0 ? segment.start.x : root[static_cast<std::size_t>(segment.parent)];
  }
  // The boundary between both is at −1.
  std::uint32_t left = 0;
  for (const std::size_t tip : tips_of(plant)) {
    const float x = plant.segments[tip].end.x;
    if (std::fabs(x + 1) > 1e-4f) CHECK(root[tip] == (x < -1 ? -6.0f : 4.0f));
    left += x < -1;
  }
  CHECK(left > 50);
}

TEST_CASE("particles that reach no target are left out with a note") {
  const SpaceOptions open{.parameters = {{"particles", 300}, {"pattern", 2}}};
  SpaceOptions closed = open;
  closed.obstacles = hut(0);
  const Plant all = grow_tree(open), none = grow_tree(closed);
  CHECK(none.segments.empty());
  CHECK(count_of(none, "particles") == 0);
  REQUIRE(none.notes.size() == 1);
  CHECK(english(none.notes[0]) ==
        std::to_string(count_of(all, "particles")) + " particles have no way past the obstacles and were left out.");
}

TEST_CASE("stragglers are counted") {
  // Particles never arrive with steps of length 0.
  const std::vector<glm::vec3> starts{{1, 2, 0}, {-1, 2, 0}, {0, 2, 1}}, targets{{0.5f, 0, 0}, {-0.5f, 0, 0}};
  for (const float step : {0.0f, 0.35f}) {
    const Solid crown(box({-2, 1, -2}, {2, 3, 2}));
    const auto ran =
        run(starts, targets, 0.3f, {.rules = {.step = step, .merge = 0}}, {}, {}, {crown, crown}, {}, 1, {});
    REQUIRE(ran);
    const Wood& wood = ran.value();
    CHECK(wood.tally.particles == 3);
    CHECK(wood.tally.energy == 3);
    CHECK(wood.tally.stragglers == (step > 0 ? 0 : 3));
  }
}

}  // namespace
}  // namespace panicle::particles
