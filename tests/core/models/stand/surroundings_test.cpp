// Light and room that neighbours take.
#include <algorithm>
#include <cmath>

#include "models/stand/plans.hpp"

using namespace panicle;
using namespace panicle::stand;
using namespace panicle::stand::tests;

namespace {

// Trees 4 m wide and 8 m high, with the axes unturned.
std::vector<float> around(const std::vector<glm::vec3>& feet, float scale = 1) {
  const Plan plan = sound(read_plan("plants 1, random\na/b, crown 4 x 8"));
  std::vector<Placement> plants;
  for (const glm::vec3& foot : feet) {
    plants.emplace_back();
    plants.back().at = foot;
  }
  plants[0].scale = scale;
  return surroundings_of(plan, plants);
}

}  // namespace

TEST_CASE("stand: a single plant has the whole sky and unlimited room") {
  const auto alone = around({{0, 0, 0}});
  for (std::size_t k = 0; k < 8; ++k) {
    CHECK(alone[k] == 0);
    CHECK(alone[8 + k] == no_neighbour);
  }
}

TEST_CASE("stand: a neighbour covers the sky in its direction, and the room ends half-way") {
  const auto both = around({{0, 0, 0}, {6, 0, 0}});
  // From 4 m up to a top of 8 m, 5 m away.
  CHECK(both[0] == 39);
  CHECK(both[4] == 0);
  CHECK(both[1] < both[0]);
  CHECK(both[1] > 0);
  CHECK(both[8] == doctest::Approx(3));
  CHECK(both[8 + 1] == 4.24f);
  CHECK(both[8 + 2] == no_neighbour);
  CHECK(both[8 + 4] == no_neighbour);
  // And the other way round, at 180°.
  CHECK(both[16 + 4] == doctest::Approx(both[0]));
  CHECK(both[16 + 8 + 4] == doctest::Approx(3));
}

TEST_CASE("stand: directions turn with the plant, room is at its own scale, and plants far away are not neighbours") {
  const Plan plan = sound(read_plan("plants 1, random\na/b, crown 4 x 8"));
  std::vector<Placement> plants(2);
  plants[1].at = {0, 0, 6};
  plants[0].turn = 90;
  CHECK(surroundings_of(plan, plants)[0] == 39);
  CHECK(around({{0, 0, 0}, {6, 0, 0}}, 2)[8] == doctest::Approx(6 * 2 / 3.0 / 2));
  CHECK(around({{0, 0, 0}, {30, 0, 0}})[0] == 0);
}

TEST_CASE("stand: surroundings are whole degrees and centimetres, with some room at least") {
  const PlacedStand all = placed("ground 9 x 9, relief 1\nplants 40, random\na/b, crown 3 x 4, scale 0.5 to 1.5");
  const auto surroundings = surroundings_of(all.plan, all.plants);
  for (std::size_t i = 0; i < surroundings.size(); ++i) {
    const float steps = i % 16 < 8 ? 1.0f : 100.0f;
    CHECK(std::round(steps * surroundings[i]) / steps == surroundings[i]);
    if (i % 16 >= 8) CHECK(surroundings[i] >= least_room);
  }
  CHECK(around({{0, 0, 0}, {0.001f, 0, 0}})[8] == least_room);
}

TEST_CASE("stand: an attached plant is not a neighbour and has none") {
  const PlacedStand all = placed("ground 20 x 20\nplants 4, rows 5 x 5\na/b\nc/d, each 2");
  const auto with = surroundings_of(all.plan, all.plants);
  std::vector<Placement> standing(all.plants.begin(), all.plants.begin() + 4);
  const auto without = surroundings_of(all.plan, standing);
  for (std::size_t i = 0; i < without.size(); ++i) CHECK(with[i] == without[i]);
  CHECK(with[16 * 4] == 0);
  CHECK(with[16 * 4 + 8] == no_neighbour);
}

TEST_CASE("stand: surroundings by many neighbours are the least that any of them leaves, exactly") {
  const PlacedStand all = placed(
      "ground 8 x 8, relief 1\nplants 60, random\na/b, crown 3 x 4, scale 1 to 1.5\nc/d, crown 1 x 15, share 0.2");
  const auto together = surroundings_of(all.plan, all.plants);
  for (std::size_t i = 0; i < all.plants.size(); ++i) {
    std::vector<float> one(8, 0.0f);
    one.resize(16, no_neighbour);
    for (std::size_t j = 0; j < all.plants.size(); ++j) {
      if (j == i) continue;
      const auto pair = surroundings_of(all.plan, {all.plants[i], all.plants[j]});
      for (std::size_t k = 0; k < 8; ++k) {
        one[k] = std::max(one[k], pair[k]);
        one[8 + k] = std::min(one[8 + k], pair[8 + k]);
      }
    }
    for (std::size_t k = 0; k < 16; ++k) CHECK(together[16 * i + k] == one[k]);
  }
}
