#include "models/bunch/natural/flowers.hpp"

#include <doctest/doctest.h>

#include "models/bunch/natural/stages.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

TEST_CASE("a flower has its parent, its place among its siblings and its strength") {
  const Twig twig;
  const std::vector<Ball> balls{{{}, 0.3f, {1, 0, 0}, 2, 70}, {{}, 25, {0, -1, 0}, 3, 80}, {{}, 0, {0, -1, 0}, 3, 80}};
  const std::vector<Flower> flowers = flowers_of(twig.internodes, balls, 1);
  REQUIRE(flowers.size() == 3);
  CHECK(flowers[0].strength == 0.3f);
  CHECK(flowers[1].strength == 1);
  CHECK(flowers[2].strength > 0);
  CHECK(flowers[0].depth == 2);
  CHECK(flowers[0].place == 0);
  CHECK(flowers[1].place == 1);
  CHECK(flowers[2].place == 2);
  CHECK(flowers[0].bunch == 0);
  CHECK(flowers[1].bunch == 1);
  CHECK(flowers[0].address == 70);
  CHECK(flowers[1].address != flowers[2].address);
}

TEST_CASE("an organ in several internodes counts as one, in depth and in flowers per end structure") {
  Twig twig;
  twig.internodes.push_back(stem(3, Kind::pedicel, {20, -60, 0}, {20, -65, 0}, true));
  const std::vector<Ball> balls{{{}, 1, {1, 0, 0}, 2, 70}, {{}, 1, {0, -1, 0}, 5, 80}};
  const std::vector<Flower> flowers = flowers_of(twig.internodes, balls, 2);
  CHECK(flowers[1].depth == flowers[0].depth);
  CHECK(flowers_per_end(twig.internodes, flowers) == 2);
  CHECK(flowers_per_end(std::vector<Internode>{twig.internodes[0]}, {}) == 0);
  CHECK(beginning_of(twig.internodes, 5) == 3);
}
