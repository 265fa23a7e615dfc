#include "models/particles/trail_plant.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <string_view>

#include "foundation/english.hpp"

namespace panicle::particles {
namespace {

// Two starts that meet at a fork and go on to the target; energies 1 and 2.
//   0 target ← 1 ← 2 fork ← 3 start (1), 4 start (2)
Trails fork() {
  return {.places = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {-1, 3, 0}, {1, 3, 0}},
          .next = {-1, 0, 1, 2, 2},
          .energy = {3, 3, 3, 1, 2},
          .born = {4, 3, 2, 1, 1},
          .particle = {-1, -1, -1, 0, 1}};
}

template <class Value>
std::vector<Value> column(const Plant& plant, std::string_view name) {
  for (std::size_t i = 0; i < plant.columns.size(); ++i) {
    const ColumnView view = plant.columns[i];
    if (view.name != name) continue;
    std::vector<Value> values(view.rows * view.width);
    std::memcpy(values.data(), view.data, values.size() * sizeof(Value));
    return values;
  }
  return {};
}

TEST_CASE("radii follow the energy by each law, and none is below the thinnest") {
  Girth girth{.law = WidthLaw::linear, .thickest = 8, .thinnest = 0.1f};
  CHECK(radius_of(girth, 16, 64) == doctest::Approx(2));
  girth.law = WidthLaw::square_root;
  CHECK(radius_of(girth, 16, 64) == doctest::Approx(4));
  girth.law = WidthLaw::power;
  girth.exponent = 1.0f / 3;
  CHECK(radius_of(girth, 8, 64) == doctest::Approx(4));
  CHECK(radius_of(girth, 0, 64) == 0.1f);
  CHECK(radius_of(girth, 0, 0) == 0.1f);
}

TEST_CASE("Leonardo's and Murray's rules hold at a fork") {
  const auto sum = [](const Girth& girth, float exponent) {
    return std::pow(radius_of(girth, 1, 3), exponent) + std::pow(radius_of(girth, 2, 3), exponent);
  };
  const Girth leonardo{.law = WidthLaw::square_root, .thickest = 5};
  CHECK(sum(leonardo, 2) == doctest::Approx(25));
  const Girth murray{.law = WidthLaw::power, .exponent = 1.0f / 3, .thickest = 5};
  CHECK(sum(murray, 3) == doctest::Approx(125));
}

TEST_CASE("trails become segments, parents first, from the target out") {
  Plant plant;
  const Trails trails[] = {fork()};
  const double all[] = {3};
  const Girth girth{.law = WidthLaw::linear, .thickest = 3};
  const auto numbers = add_trails(plant, trails, all, girth, {.origin = {0, 10, 0}, .scale = 2}, {2, 1, 4, 3}, 0);
  REQUIRE(plant.segments.size() == 4);
  CHECK(numbers[0] == std::vector<std::int32_t>{-1, 0, 1, 2, 3});
  CHECK(plant.segments[0].parent == -1);
  CHECK(plant.segments[0].start == glm::vec3(0, 10, 0));
  CHECK(plant.segments[0].end == glm::vec3(0, 12, 0));
  CHECK(plant.segments[2].parent == 1);
  CHECK(plant.segments[3].parent == 1);
  // As thick at a fork as the heavier of those that go on; nothing flows into a start.
  CHECK(plant.segments[1].radius == 3);
  CHECK(plant.segments[1].radius_end == 2);
  CHECK(plant.segments[3].radius == 2);
  CHECK(plant.segments[3].radius_end == 0);
  CHECK(column<float>(plant, "segments.energy") == std::vector<float>{3, 3, 1, 2});
  CHECK(column<std::uint32_t>(plant, "segments.born") == std::vector<std::uint32_t>{3, 2, 1, 1});
  CHECK(column<float>(plant, "targets.places") == std::vector<float>{0, 10, 0});
  CHECK(column<float>(plant, "targets.energy") == std::vector<float>{3});
  CHECK(plant.counts[1].name == "energy");
  CHECK(plant.counts[1].value == 3);
  CHECK(plant.notes.empty());
}

TEST_CASE("stragglers get a note") {
  Plant plant;
  const Trails trails[] = {fork()};
  const double all[] = {3};
  add_trails(plant, trails, all, {}, {}, {.particles = 2, .stragglers = 2}, 0);
  REQUIRE(plant.notes.size() == 1);
  CHECK(english(plant.notes[0]) == "2 particles did not reach their target by themselves, so they were moved there.");
}

}  // namespace
}  // namespace panicle::particles
