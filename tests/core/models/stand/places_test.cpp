// Placement of plants: their number, their distances, their kinds, and random values of their own.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/english.hpp"
#include "foundation/mathematics.hpp"
#include "models/stand/plans.hpp"

using namespace panicle;
using namespace panicle::stand;
using namespace panicle::stand::tests;

namespace {

float nearest(const std::vector<Placement>& plants) {
  float least = 1e9f;
  for (std::size_t i = 0; i < plants.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, glm::distance(flat(plants[i]), flat(plants[j])));
  return least;
}

}  // namespace

TEST_CASE("stand: every spacing places the requested number on the ground") {
  for (const char* const spacing : {"random", "stratified", "blue", "blue 1.5", "rows 3 x 2"}) {
    CAPTURE(spacing);
    const auto plants = placed(std::string("ground 60 x 40, relief 3\nplants 300, ") + spacing + "\na/b").plants;
    CHECK(plants.size() == 300);
    for (const Placement& plant : plants) {
      CHECK(std::abs(plant.at.x) <= 30);
      CHECK(std::abs(plant.at.z) <= 20);
      CHECK(std::abs(plant.at.y) <= 1.5f);
    }
  }
}

TEST_CASE("stand: the thinnest allowed strip contains its layer") {
  for (const char* const ground : {"ground 1000 x 0.1", "ground 0.1 x 1000"})
    for (const char* const plants :
         {"plants 5000, stratified", "plants 200, blue", "plants 1, blue", "plants 9, random"})
      for (const char* const depth : {"0 to 0.001", "0.999 to 1"}) {
        const std::string text = std::string(ground) + "\n" + plants + ", depth " + depth + "\na/b";
        CAPTURE(text);
        const PlacedStand all = placed(text);
        CHECK(all.plants.size() == all.plan.layers[0].count);
        for (const Placement& plant : all.plants) {
          CHECK(std::abs(plant.at.x) <= 0.5f * all.plan.ground.width);
          CHECK(std::abs(plant.at.z) <= 0.5f * all.plan.ground.depth);
        }
      }
}

TEST_CASE("stand: layers keep their proportion at another requested number") {
  const char* const text = "plants 30, blue 0.2\na/b\nplants 10, random\nc/d";
  const auto plants = placed(text, 1, 200).plants;
  CHECK(plants.size() == 200);
  CHECK(std::count_if(plants.begin(), plants.end(), [](const Placement& each) { return each.kind == 1; }) == 50);
}

TEST_CASE("stand: the requested number is exact, however small, and a note lists layers without plants") {
  const char* const text = "plants 60, random\na/b\nplants 30, random\nc/d\nplants 50, random\ne/f";
  for (const std::uint32_t requested : {1u, 2u, 3u, 7u, 24u, 139u, 140u, 141u, 3000u}) {
    CAPTURE(requested);
    const PlacedStand all = placed(text, 1, requested);
    CHECK(all.plants.size() == requested);
    std::vector<double> of(3, 0);
    for (const Placement& plant : all.plants) ++of[plant.kind];
    CHECK(std::abs(of[0] - requested * 60 / 140.0) < 1);
    CHECK(std::abs(of[1] - requested * 30 / 140.0) < 1);
    CHECK(std::abs(of[2] - requested * 50 / 140.0) < 1);
    CHECK(all.notes.size() == static_cast<std::size_t>(std::count(of.begin(), of.end(), 0)));
  }
  const PlacedStand one = placed(text, 1, 1);
  REQUIRE(one.notes.size() == 2);
  CHECK(english(one.notes[0]).find("line 1") != std::string::npos);
  CHECK(english(one.notes[1]).find("line 3") != std::string::npos);
}

TEST_CASE("stand: blue noise keeps the given distance, and a full ground has a note") {
  const PlacedStand some = placed("ground 30 x 30\nplants 400, blue 1\na/b");
  CHECK(some.notes.empty());
  CHECK(nearest(some.plants) >= 1);
  const PlacedStand full = placed("ground 10 x 10\nplants 400, blue 1\na/b");
  CHECK(full.plants.size() < 90);
  CHECK(full.plants.size() > 50);
  REQUIRE(full.notes.size() == 1);
  CHECK(english(full.notes[0]).find("could not be placed") != std::string::npos);
}

TEST_CASE("stand: blue noise without a distance finds room for all and is far more even than chance") {
  const float blue = nearest(placed("ground 50 x 50\nplants 500, blue\na/b").plants);
  CHECK(blue >= 0.69f * std::sqrt(2500.0f / 500));
  CHECK(blue > 5 * nearest(placed("ground 50 x 50\nplants 500, random\na/b").plants));
}

TEST_CASE("stand: each stratum has one plant") {
  const auto plants = placed("ground 20 x 10\nplants 200, stratified\na/b").plants;
  std::vector<int> cells(200, 0);
  for (const Placement& plant : plants)
    ++cells[static_cast<std::size_t>(plant.at.z + 5) * 20 + static_cast<std::size_t>(plant.at.x + 10)];
  CHECK(std::count(cells.begin(), cells.end(), 1) == 200);
}

TEST_CASE("stand: rows have the given direction and distance, and fill the ground") {
  const auto plants = placed("ground 20 x 20\nplants, rows 4 x 2\na/b").plants;
  CHECK(plants.size() == 5 * 11);
  for (const Placement& plant : plants) {
    CHECK(std::fmod(std::abs(plant.at.z), 4.0f) == doctest::Approx(0));
    CHECK(std::fmod(std::abs(plant.at.x), 2.0f) == doctest::Approx(0));
    CHECK((plant.turn == 0 || plant.turn == 180));
  }
  for (const Placement& plant : placed("ground 20 x 20\nplants, rows 4 x 2, towards 90\na/b").plants)
    CHECK(std::fmod(std::abs(plant.at.x), 4.0f) == doctest::Approx(0).epsilon(0.001));
  float off = 0;
  for (const Placement& plant : placed("ground 20 x 20\nplants, rows 4 x 4, jitter 0.5\na/b").plants)
    off = std::max(off, std::abs(plant.at.z - 4 * std::round(plant.at.z / 4)));
  CHECK(off > 0.3f);
  CHECK(off <= 0.5f);
}

TEST_CASE("stand: fewer plants fill whole rows about the middle, and the last row from its middle") {
  // Five rows of eleven.
  for (const char* const count : {"plants", "plants 55"}) {
    const std::string text = "ground 20 x 20\n" + std::string(count) + ", rows 4 x 2\na/b";
    CHECK(placed(text).plants.size() == 55);
    const auto plants = placed(text, 1, 25).plants;
    REQUIRE(plants.size() == 25);
    const auto in_row = [&](float z) {
      return std::count_if(plants.begin(), plants.end(), [&](const Placement& each) { return each.at.z == z; });
    };
    CHECK(in_row(0) == 11);
    CHECK(in_row(-4) == 11);
    CHECK(in_row(4) == 3);
    for (const Placement& plant : plants)
      if (plant.at.z == 4) CHECK(std::abs(plant.at.x) <= 2);
  }
  // Also of more plants than the limit, in rows and within a row.
  for (const char* const rows : {"1 x 1", "1 x 0.02"})
    for (const Placement& plant :
         placed("ground 200 x 200\nplants 5000, rows " + std::string(rows) + "\na/b", 1, 50).plants) {
      CHECK(plant.at.z == 0);
      CHECK(std::abs(plant.at.x) <= 25);
    }
}

TEST_CASE("stand: rows of any direction use all of their places in the strip") {
  for (const int towards : {0, 1, 30, 45, 90, 137, 180, -89, -270}) {
    CAPTURE(towards);
    const PlacedStand all = placed("ground 40 x 30\nplants, rows 0.7 x 0.5, depth 0.1 to 0.35, towards " +
                                   std::to_string(towards) + "\na/b");
    const float turn = static_cast<float>(towards) * pi / 180;
    std::size_t inner = 0, outer = 0;
    for (int row = -60; row <= 60; ++row)
      for (int place = -90; place <= 90; ++place) {
        const float u = 0.7f * static_cast<float>(row), v = 0.5f * static_cast<float>(place);
        const float x = std::abs(v * std::cos(turn) - u * std::sin(turn));
        const float z = std::abs(v * std::sin(turn) + u * std::cos(turn));
        inner += x < 20 - 1e-3f && z < 3.75f - 1e-3f;
        outer += x < 20 + 1e-3f && z < 3.75f + 1e-3f;
      }
    CHECK(all.plants.size() >= inner);
    CHECK(all.plants.size() <= outer);
  }
}

// Ten thousand million places would be visited if each were tested against the strip.
TEST_CASE("stand: rows far finer than the ground are placed in a strip of it") {
  for (const char* const towards : {"0", "30", "90"}) {
    CAPTURE(towards);
    const std::string text = std::string("rows 0.01 x 0.01, depth 0 to 0.001, towards ") + towards + "\na/b";
    const PlacedStand one = placed("ground 1000 x 1000\nplants 1, " + text);
    CHECK(one.plants.size() == 1);
    CHECK(one.plants[0].at.z <= -499);
    CHECK(placed("ground 1000 x 1000\nplants 5000, " + text).plants.size() == 5000);
  }
}

TEST_CASE("stand: a strip contains its layer") {
  for (const Placement& plant : placed("ground 20 x 20\nplants 50, random, depth 0.75 to 1\na/b").plants)
    CHECK(plant.at.z >= 5);
}

TEST_CASE("stand: shares are met within chance") {
  const auto plants = placed("ground 100 x 100\nplants 4000, random\na/b, share 3\nc/d, share 1\ne/f, share 0").plants;
  std::vector<int> of(3, 0);
  for (const Placement& plant : plants) ++of[plant.kind];
  CHECK(std::abs(of[0] - 3000) < 110);  // four standard deviations
  CHECK(of[0] + of[1] == 4000);
}

TEST_CASE("stand: values are drawn over the whole range for each plant; words are NaN") {
  const auto plants = placed("plants 2000, random\na/b, scale 0.5 to 2: age 10 to 20, leaf oak, steps 3").plants;
  float least = 1e9f, most = 0;
  for (const Placement& plant : plants) {
    least = std::min(least, plant.settings[0]);
    most = std::max(most, plant.settings[0]);
    CHECK(std::isnan(plant.settings[1]));
    CHECK(plant.settings[2] == 3);
    CHECK(plant.scale >= 0.5f);
    CHECK(plant.scale <= 2);
  }
  CHECK(least < 10.1f);
  CHECK(most > 19.9f);
  CHECK(most <= 20);
}

TEST_CASE("stand: `seeds` sets the number of different plants, and plants of one seed have equal values") {
  const auto plants = placed("plants 500, random\na/b, seeds 4, scale 1 to 2: age 10 to 20").plants;
  std::vector<std::pair<std::uint32_t, float>> found;
  for (const Placement& plant : plants) found.emplace_back(plant.seed, plant.settings[0]);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  CHECK(found.size() == 4);
  CHECK(plants[0].scale != plants[1].scale);
}

TEST_CASE("stand: attached plants hang on each parent, along its row") {
  const auto plants =
      placed("plants 20, rows 4 x 4\na/b, scale 2\nc/d, each 3 to 5, height 0.8 to 1, reach 0.5").plants;
  std::vector<int> of(20, 0);
  for (const Placement& plant : plants) {
    if (plant.parent < 0) continue;
    const Placement& by = plants[static_cast<std::size_t>(plant.parent)];
    ++of[static_cast<std::size_t>(plant.parent)];
    CHECK(plant.at.y - by.at.y >= 1.6f);
    CHECK(plant.at.y - by.at.y <= 2);
    CHECK(std::abs(plant.at.x - by.at.x) <= 1.001f);
    CHECK(std::abs(plant.at.z - by.at.z) <= 0.101f);
  }
  CHECK(*std::min_element(of.begin(), of.end()) == 3);
  CHECK(*std::max_element(of.begin(), of.end()) == 5);
}

TEST_CASE("stand: the same seed gives the same plants, another seed others; a plant does not depend on their number") {
  const char* const text = "ground 40 x 40, relief 2\nplants 100, blue 1\na/b: age 1 to 9";
  const auto once = placed(text, 7).plants, again = placed(text, 7).plants, other = placed(text, 8).plants;
  const auto fewer = placed(text, 7, 40).plants;
  int same = 0;
  for (std::size_t i = 0; i < once.size(); ++i) {
    CHECK(once[i].at == again[i].at);
    CHECK(once[i].seed == again[i].seed);
    CHECK(once[i].settings == again[i].settings);
    same += once[i].seed == other[i].seed;
    if (i < fewer.size()) CHECK(fewer[i].seed == once[i].seed);
  }
  CHECK(same == 0);
}

TEST_CASE("stand: more than 5,000 plants are refused before they are placed") {
  const Plan plan = sound(read_plan("ground 1000 x 1000\nplants, rows 1 x 1\na/b"));
  std::vector<std::string> notes;
  const auto none = place(plan, Relief(plan.ground, 1), 1, 0, notes);
  REQUIRE_FALSE(none);
  CHECK(none.error().reason == Reason::limit);
}
