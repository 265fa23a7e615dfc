#include "light/sky_visibility.hpp"

#include <doctest/doctest.h>

#include "foundation/random.hpp"
#include "light/density_grid.hpp"

namespace panicle {
namespace {

std::vector<Occluder> crowd(float scale) {
  std::vector<Occluder> screens;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const auto draw = [&](std::uint64_t stream) { return random_unit(3, stream, i); };
    screens.push_back({scale * glm::vec3(draw(0), draw(1), draw(2)), scale * scale * 0.01f});
  }
  return screens;
}

}  // namespace

TEST_CASE("put adds matter to the cell of its place") {
  // Three cells in a row, an area of 0.5 in the last one, of which half a length of 2 is in the way of a cell's middle.
  DensityGrid cells({0, 0, 0}, {5, 0, 0}, 2);
  cells.put({4.5f, 0.1f, 0.1f}, 0.5f);
  const std::vector<float> matter = {0, 0, 0.5f / 8};
  for (const std::vector<LightDirection>& lamps : {all_round(12), overcast(7)}) {
    const VoxelLight expected({0, 0, 0}, 2, 3, 1, 1, matter, lamps), light = cells.light(lamps);
    for (float x = -1; x < 8; x += 0.5f) CHECK(light.at({x, 1, 1}) == expected.at({x, 1, 1}));
    CHECK(light.at({5, 1, 1}) < light.at({1, 1, 1}));
  }
  // Matter beside the lattice counts in the nearest cell.
  DensityGrid beside({0, 0, 0}, {5, 0, 0}, 2);
  beside.put({99, -3, 7}, 0.5f);
  CHECK(beside.light(all_round(12)).at({5, 1, 1}) == cells.light(all_round(12)).at({5, 1, 1}));
}

TEST_CASE("a plant is light at its edge and dark within, at any size") {
  const SkyVisibility alone({}, {});
  CHECK(alone.at({1, 2, 3}) == 255);
  const SkyVisibility small({}, crowd(1)), large({}, crowd(64));
  const int within = small.at({0.5f, 0.5f, 0.5f}), above = small.at({0.5f, 1.2f, 0.5f});
  CHECK(within < 60);
  CHECK(above > 2 * within);
  CHECK(large.at({32, 32, 32}) == within);
  CHECK(large.at({32, 76.8f, 32}) == above);
}

TEST_CASE("of() gives the same for many places as at() for each, outside the lattice too") {
  const SkyVisibility open({}, crowd(1));
  std::vector<glm::vec3> places;
  for (std::uint64_t i = 0; i < 403; ++i) places.push_back(2.0f * random_direction(5, 1, i) * random_unit(5, 2, i));
  const std::vector<std::uint8_t> bytes =
      open.of(places.size(), [&](std::size_t i) -> const glm::vec3& { return places[i]; });
  REQUIRE(bytes.size() == places.size());
  for (std::size_t i = 0; i < places.size(); ++i) CHECK(bytes[i] == open.at(places[i]));
}

TEST_CASE("a rod hides as much as an occluder of a quarter of its surface") {
  Segment rod;
  rod.end = {0, 2, 0};
  rod.radius = 0.2f;
  rod.radius_end = 0.1f;
  const std::vector<Segment> rods(1, rod);
  // Its surface: 2π × 0.15 × 2. The lattice is bounded by the same ends.
  const std::vector<Occluder> screens = {{{0, 1, 0}, 0.25f * 3.14159265f * 0.3f * 2}, {{0, 0, 0}, 0}, {{0, 2, 0}, 0}};
  const SkyVisibility of_rod(rods, {}), of_screen({}, screens);
  for (float y = 0; y <= 2; y += 0.125f) CHECK(of_rod.at({0, y, 0}) == of_screen.at({0, y, 0}));
  CHECK(of_rod.at({0, 1, 0}) < 250);
}

}  // namespace panicle
