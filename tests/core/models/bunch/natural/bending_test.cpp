#include "models/bunch/natural/settling/bending.hpp"

#include <doctest/doctest.h>

#include "models/bunch/natural/stages.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

struct Bend {
  Twig twig;
  Hanging hanging;
  std::vector<FlowerOutcome> outcomes{{FlowerState::berry, {32, -54, 0}}, {FlowerState::berry, {22, -62, 0}}};
  std::vector<glm::vec3> ends;
  Bend() {
    hanging = hang(twig.internodes, twig.flowers, 1);
    for (const Branch& branch : hanging.branches) ends.push_back(branch.end);
  }
  BentSkeleton run(float size = 1) const {
    return bend_skeleton(twig.internodes, twig.flowers, hanging, outcomes, ends, size);
  }
};

glm::vec3 millimetres(float x, float y, float z) { return glm::vec3(x, y, z) * 0.001f; }

bool near(const glm::vec3& a, const glm::vec3& b) { return glm::length(a - b) < 1e-7f; }

}  // namespace

TEST_CASE("stems end where swelling left them, in metres, and pedicels at their berries") {
  Bend bend;
  bend.ends[1] = {21, -52, 0};
  const BentSkeleton bent = bend.run();
  REQUIRE(bent.internodes.size() == 5);
  CHECK(near(bent.internodes[1].end, millimetres(21, -52, 0)));
  CHECK(bent.internodes[2].start == bent.internodes[1].end);
  CHECK(near(bent.internodes[2].end, millimetres(32, -54, 0)));
  CHECK(near(bent.internodes[3].end, millimetres(22, -62, 0)));
  CHECK(bent.internodes[2].radius_end > bent.internodes[2].radius);  // where the berry sits
}

TEST_CASE(
    "stems of a bunch in flower are little over half as thick as ripe ones, and thicken up to a berry size of 0.64") {
  const Bend bend;
  const auto girth = [&](float size) { return bend.run(size).internodes[0].radius / 0.001f; };
  CHECK(girth(0) == doctest::Approx(0.55));
  CHECK(girth(0.32f) == doctest::Approx(0.775));
  CHECK(girth(0.64f) == doctest::Approx(1));
  CHECK(girth(1) == doctest::Approx(1));
}

TEST_CASE(
    "a berry that was lost leaves a withered stub, a flower hangs on its young stalk, a fallen one takes it along") {
  Bend bend;
  bend.outcomes[0].state = FlowerState::stub;
  bend.outcomes[1].state = FlowerState::flower;
  const BentSkeleton some = bend.run(0.08f);
  REQUIRE(some.internodes.size() == 5);
  CHECK(some.internodes[2].state == State::withered);
  CHECK(near(some.internodes[2].end, millimetres(23, -50, 0)));
  CHECK(some.internodes[3].state == State::grown);
  CHECK(near(some.internodes[3].end, millimetres(20, -50 - 10 * stalk_at(0.08f), 0)));
  bend.outcomes[1].state = FlowerState::fallen;
  const BentSkeleton fewer = bend.run();
  CHECK(fewer.place_of == std::vector<std::int32_t>{0, 1, 2, -1, 3});
}

TEST_CASE("stems that have lost all flowers fall, except the rachis and stems that never had any") {
  Bend bend;
  bend.outcomes[0].state = bend.outcomes[1].state = FlowerState::fallen;
  CHECK(bend.run().place_of == std::vector<std::int32_t>{0, 1, -1, -1, 2});  // the thorn holds its twig
  bend.twig.internodes.pop_back();
  bend.hanging = hang(bend.twig.internodes, bend.twig.flowers, 1);
  CHECK(bend.run().place_of == std::vector<std::int32_t>{0, -1, -1, -1});
}

TEST_CASE("a stalk of several internodes follows its berry as a whole, together with the parts on it") {
  std::vector<Internode> chain{
      stem(-1, Kind::rachis, {0, 0, 0}, {0, -50, 0}), stem(0, Kind::pedicel, {0, -50, 0}, {5, -50, 0}),
      stem(1, Kind::pedicel, {5, -50, 0}, {10, -55, 0}, true), stem(1, Kind::axis, {5, -50, 0}, {5, -48, 0})};
  const std::vector<Flower> flowers{flower_on(2, {1, 0, 0})};
  const Hanging hanging = hang(chain, flowers, 1);
  const std::vector<glm::vec3> ends{{1, -50, 0}};
  // Turned by a right angle about z: (10, −5) becomes (5, 10).
  const std::vector<FlowerOutcome> outcomes{{FlowerState::berry, {6, -40, 0}}};
  const BentSkeleton bent = bend_skeleton(chain, flowers, hanging, outcomes, ends, 1);
  REQUIRE(bent.internodes.size() == 4);
  CHECK(glm::length(bent.internodes[1].end - millimetres(1, -45, 0)) < 1e-6f);
  CHECK(near(bent.internodes[2].end, millimetres(6, -40, 0)));
  CHECK(bent.internodes[2].start == bent.internodes[1].end);
  CHECK(near(bent.internodes[3].end - bent.internodes[3].start, millimetres(0, 2, 0)));
}

TEST_CASE("a pedicel of two berries ends between them; if one is lost, at the other") {
  std::vector<Internode> two{stem(-1, Kind::rachis, {0, 0, 0}, {0, -50, 0}),
                             stem(0, Kind::pedicel, {0, -50, 0}, {10, -50, 0})};
  const std::vector<Flower> flowers{flower_on(1, {1, 0, 0}), flower_on(1, {1, 0, 0}, 1)};
  const Hanging hanging = hang(two, flowers, 1);
  const std::vector<glm::vec3> ends{{0, -50, 0}};
  std::vector<FlowerOutcome> outcomes{{FlowerState::berry, {10, -46, 0}}, {FlowerState::berry, {10, -58, 0}}};
  const BentSkeleton both = bend_skeleton(two, flowers, hanging, outcomes, ends, 1);
  CHECK(near(both.internodes[1].end, millimetres(10, -52, 0)));
  CHECK(both.internodes[1].radius_end == doctest::Approx(0.00135));
  outcomes[0].state = FlowerState::stub;
  const BentSkeleton one = bend_skeleton(two, flowers, hanging, outcomes, ends, 1);
  CHECK(near(one.internodes[1].end, millimetres(10, -58, 0)));
  CHECK(one.internodes[1].state == State::grown);
}
