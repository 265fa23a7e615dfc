#include "models/bunch/natural/harvest.hpp"

#include <doctest/doctest.h>

#include "models/bunch/natural/stages.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

// The first flower's berry has the outcome `lost`; the second flower did not set.
struct Late {
  Sprout sprout;
  Hanging hanging;
  Crop crop;
  explicit Late(RemovalReason lost) {
    const Twig twig;
    sprout.internodes = twig.internodes;
    sprout.flowers = twig.flowers;
    hanging = hang(sprout.internodes, sprout.flowers, 1);
    crop.set.volumes = {1, 0};
    crop.elongation = 1.5f;
    crop.fruitlets = {{0, 10, 15, false}};
    crop.berries.resize(1);
    crop.berries[0].branch = 1;
    crop.swollen = {{{0, -50, 0}, {20, -50, 0}, {20, -45, 0}}, {{40, -50, 0}}, {{1, 0, 0}}, {lost}, {}};
  }
  Harvest at(float age, float size) const {
    const std::vector<FlowerOutcome> outcomes = outcomes_of(crop, sprout.flowers, 1, age, size);
    const BentSkeleton bent =
        bend_skeleton(sprout.internodes, sprout.flowers, hanging, outcomes, crop.swollen.ends, size);
    return harvest(crop, sprout, hanging, outcomes, bent, size, 20);
  }
};

}  // namespace

TEST_CASE("a berry has the size of its age, in metres, and sits on its pedicel") {
  const Harvest ripe = Late(RemovalReason{}).at(100, 1);
  REQUIRE(ripe.bodies.size() == 1);
  CHECK(ripe.bodies[0].half_width == 10);
  CHECK(ripe.bodies[0].half_length == 15);
  CHECK(ripe.berries[0].centre.x == doctest::Approx(0.04));
  CHECK(ripe.berries[0].radius == doctest::Approx(0.01 * 1.1447));  // cube root of 1.5
  CHECK(ripe.berries[0].parent == 2);
  CHECK(Late(RemovalReason{}).at(30, 0.5f).bodies[0].half_width == 5);
  const std::vector<FlowerOutcome> outcomes =
      outcomes_of(Late(RemovalReason{}).crop, Late(RemovalReason{}).sprout.flowers, 1, 100, 1);
  CHECK(outcomes[0].state == FlowerState::berry);
  CHECK(outcomes[0].seat.x == doctest::Approx(40 - 0.96 * 15));
}

TEST_CASE("flowers that do not set hang there until they fall; then they are listed where their pedicel began") {
  const Harvest early = Late(RemovalReason{}).at(5, 0.08f);
  REQUIRE(early.bodies.size() == 2);
  CHECK(early.flowers[1] == 1);
  CHECK(early.bodies[1].half_width == doctest::Approx(0.75));
  CHECK(early.thinned.empty());
  const Harvest late = Late(RemovalReason{}).at(12, 0.1f);
  CHECK(late.bodies.size() == 1);
  REQUIRE(late.thinned.size() == 1);
  CHECK(late.thinned[0].why == RemovalReason::not_set);
  CHECK(late.thinned[0].id == 1);
  CHECK(glm::length(late.thinned[0].place - glm::vec3(0.02f, -0.05f, 0)) < 1e-7f);
}

TEST_CASE("a lost berry is listed with its reason where its pedicel hung, in metres") {
  for (const RemovalReason why : {RemovalReason::no_room, RemovalReason::by_hand}) {
    const Harvest poor = Late(why).at(100, 1);
    CHECK(poor.bodies.empty());
    REQUIRE(poor.thinned.size() == 2);
    CHECK(poor.thinned[0].why == why);
    CHECK(glm::length(poor.thinned[0].place - glm::vec3(0.02f, -0.05f, 0)) < 1e-7f);
  }
}
