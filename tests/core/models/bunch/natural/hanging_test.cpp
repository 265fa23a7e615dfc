#include "models/bunch/natural/hanging.hpp"

#include <doctest/doctest.h>

#include "models/bunch/natural/stages.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

TEST_CASE("stems are branches, pedicels stalks; the rachis hardly gives, axes and twigs readily") {
  Twig twig;
  twig.internodes[4].kind = Kind::axis;
  const Hanging hanging = hang(twig.internodes, twig.flowers, 0.5f);
  CHECK(hanging.branch_of == std::vector<std::int32_t>{0, 1, -1, -1, 2});
  CHECK(hanging.stalk_from == std::vector<std::int32_t>{-1, -1, 2, 3, -1});
  REQUIRE(hanging.branches.size() == 3);
  CHECK(hanging.branches[1].parent == 0);
  CHECK(hanging.branches[0].give == doctest::Approx(0.05));
  CHECK(hanging.branches[1].give == doctest::Approx(0.4));
  CHECK(hanging.branches[2].give == doctest::Approx(0.35));
}

TEST_CASE("a stalk of several internodes is one, with its thorns; a stem that leads on beyond its flower is a branch") {
  std::vector<Internode> chain{
      stem(-1, Kind::rachis, {0, 0, 0}, {0, -50, 0}), stem(0, Kind::pedicel, {0, -50, 0}, {5, -50, 0}),
      stem(1, Kind::pedicel, {5, -50, 0}, {10, -50, 0}, true), stem(2, Kind::axis, {10, -50, 0}, {10, -45, 0})};
  const std::vector<Flower> flowers{flower_on(2, {1, 0, 0}), flower_on(0, {0, -1, 0}, 1)};
  const Hanging hanging = hang(chain, flowers, 1);
  CHECK(hanging.branch_of == std::vector<std::int32_t>{0, -1, -1, -1});
  CHECK(hanging.stalk_from == std::vector<std::int32_t>{-1, 1, 1, -1});
  std::vector<Branch> branches = hanging.branches;
  const std::vector<Fruitlet> fruitlets{{0, 8, 9, false}, {1, 8, 9, true}};
  const std::vector<Swelling> berries = hang_berries(fruitlets, chain, flowers, hanging, branches);
  CHECK(berries[0].stalk == 10);
  CHECK(berries[0].branch == 0);
  CHECK(berries[0].half_length == 9);
  CHECK(berries[1].stalk == 0);  // it sits on the rachis
  CHECK(berries[1].branch == 0);
  CHECK(berries[1].taken);
  CHECK(branches.size() == 1);
}

TEST_CASE("a stalk that grows from no branch gets a point to hang from") {
  const std::vector<Internode> alone{stem(-1, Kind::pedicel, {3, 0, 0}, {3, -10, 0})};
  const std::vector<Flower> flowers{flower_on(0, {0, -1, 0})};
  const Hanging hanging = hang(alone, flowers, 1);
  CHECK(hanging.branches.empty());
  std::vector<Branch> branches;
  const std::vector<Fruitlet> fruitlets{{0, 8, 8, false}};
  CHECK(hang_berries(fruitlets, alone, flowers, hanging, branches)[0].branch == 0);
  REQUIRE(branches.size() == 1);
  CHECK(branches[0].end == glm::vec3(3, 0, 0));
}
