#include "models/particles/vein_orders.hpp"

#include <doctest/doctest.h>

#include <numeric>

using namespace panicle::particles;

namespace {

Trails trails_of(std::vector<std::int32_t> next, std::vector<double> energy) {
  Trails trails;
  trails.places.resize(next.size());
  trails.born.resize(next.size(), 0);
  trails.particle.resize(next.size(), -1);
  trails.next = std::move(next);
  trails.energy = std::move(energy);
  return trails;
}

}  // namespace

TEST_CASE("a vein follows the most energy; trails that leave it begin veins of their own") {
  //        0 ← 1 ← 2 ← 5      1 ← 3 (a side vein), 2 ← 4 (a twig), 3 ← 6 and 7, alike
  const std::vector<Trails> crowds{trails_of({-1, 0, 1, 1, 2, 2, 3, 3}, {100, 100, 60, 40, 1, 50, 20, 20})};
  const std::vector<Vein> veins = veins_of(crowds);
  REQUIRE(veins.size() == 4);
  CHECK(veins[0].places == std::vector<std::uint32_t>{0, 1, 2, 5});
  CHECK(veins[1].places == std::vector<std::uint32_t>{1, 3, 6});
  CHECK(veins[1].parent == 0);
  CHECK(veins[2].places == std::vector<std::uint32_t>{2, 4});
  CHECK(veins[3].places == std::vector<std::uint32_t>{3, 7});
  CHECK(veins[0].order == 1);
  CHECK(veins[1].order == 2);
  // A twig on the midrib waits for the round after that of much wider veins; of the next round it is too thin as well.
  CHECK(veins[3].order == 3);
  CHECK(veins[2].order == 4);
}

TEST_CASE("veins that begin at targets are all of the first order, unless they are thin") {
  const std::vector<Trails> crowds{trails_of({-1, 0}, {50, 50}), trails_of({-1, 0}, {40, 40}),
                                   trails_of({-1, 0}, {5, 5}), trails_of({-1}, {0})};
  const std::vector<Vein> veins = veins_of(crowds);
  REQUIRE(veins.size() == 3);
  CHECK(veins[0].order == 1);
  CHECK(veins[1].order == 1);
  CHECK(veins[2].order == 2);
  CHECK(veins_of({}).empty());
}
