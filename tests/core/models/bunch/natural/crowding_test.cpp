#include "models/bunch/natural/settling/crowding.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "foundation/random.hpp"

using namespace panicle;
using namespace panicle::bunch;

namespace {

constexpr float size = 10;

// Uniformly random buds in a box.
std::vector<Bud> cloud(std::size_t count, const glm::vec3& box, std::uint64_t seed) {
  std::vector<Bud> buds;
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = [&](std::uint64_t k) { return random_unit(seed, k, i); };
    buds.push_back({box * glm::vec3(at(1), at(2), at(3)), at(4)});
  }
  return buds;
}

float crowding_of(const std::vector<Bud>& buds, const BerrySize& berry) {
  return crowding(buds, std::vector<float>(buds.size(), 1), berry);
}

float crowding_with(const std::vector<Bud>& buds, const std::vector<float>& ranks, float fill, const BerrySize& berry) {
  return crowding(buds, choose_set(ranks, fill), berry);
}

}  // namespace

TEST_CASE("berries that fill a share of space crowd each other by about that share") {
  const float edge = 260;
  for (const float share : {0.1f, 0.2f, 0.4f}) {
    CAPTURE(share);
    const auto count = static_cast<std::size_t>(share * std::pow(edge / size, 3.0f) * 6 / 3.14159f);
    const float found = crowding_of(cloud(count, glm::vec3(edge), 3), {size, 1});
    // Buds at the faces of the box have no neighbours beyond.
    CHECK(found > 0.75f * share);
    CHECK(found < share);
  }
}

TEST_CASE("a berry alone is not crowded, nor by flowers that do not set, nor by another bunch") {
  std::vector<Bud> buds{{{0, 0, 0}, 0.5f}, {{8, 0, 0}, 0.5f}};
  const BerrySize berry{size, 1};
  CHECK(crowding_of(buds, berry) > 0.01f);
  CHECK(crowding(buds, std::vector<float>{1, 0}, berry) == doctest::Approx(0));
  CHECK(crowding(buds, std::vector<float>{0, 0}, berry) == 0);
  CHECK(crowding(buds, std::vector<float>{1, 0.5f}, berry) < crowding_of(buds, berry));
  buds[1].bunch = 1;
  CHECK(crowding_of(buds, berry) == doctest::Approx(0));
}

TEST_CASE("a berry that grows beyond the outline is crowded as if it were pushed inside") {
  auto buds = cloud(300, {60, 60, 60}, 4);
  const float inside = crowding_of(buds, {size, 1});
  for (Bud& bud : buds) bud.misplaced = 0.1f;
  CHECK(crowding_of(buds, {size, 1}) > 1.15f * inside);
}

TEST_CASE("long berries crowd like round ones in a bunch that is longer by the same factor") {
  const auto round = cloud(900, {100, 100, 100}, 5);
  auto longer = round;
  for (Bud& bud : longer) bud.place.y *= 1.5f;
  CHECK(crowding_of(longer, {size, 1.5f}) == doctest::Approx(crowding_of(round, {size, 1})).epsilon(1e-4));
}

TEST_CASE("the found fill has the crowding of the density") {
  const auto buds = cloud(4000, {110, 180, 90}, 7);
  for (const float elongation : {1.0f, 1.4f}) {
    const BerrySize berry{size, elongation};
    const std::vector<float> ranks = ranks_of(buds, size);
    float before = 0;
    for (float density = 1; density <= 8.5f; density += 0.5f) {
      CAPTURE(density);
      const float fill = fill_for(buds, ranks, density, berry);
      CHECK(fill > before);
      CHECK(crowding_with(buds, ranks, fill, berry) == doctest::Approx(crowding_at(density, elongation)).epsilon(0.02));
      before = fill;
    }
  }
}

TEST_CASE("where flowers are too few for a density, nearly all set") {
  const auto buds = cloud(60, {90, 90, 90}, 8);
  const std::vector<float> ranks = ranks_of(buds, size);
  const std::vector<float> volumes = choose_set(ranks, fill_for(buds, ranks, 9, {size, 1}));
  CHECK(std::count_if(volumes.begin(), volumes.end(), [](float volume) { return volume > 0; }) == 60);
}

TEST_CASE("a flower that moves a little changes the fill a little") {
  auto buds = cloud(900, {80, 130, 80}, 9);
  const BerrySize berry{size, 1};
  float most = 0;
  for (std::size_t i = 0; i < 60; ++i) {
    const float before = fill_for(buds, ranks_of(buds, size), 5 + 0.05f * static_cast<float>(i), berry);
    for (std::size_t k = i; k < buds.size(); k += 60) buds[k].place.x += 0.3f;
    const float after = fill_for(buds, ranks_of(buds, size), 5 + 0.05f * static_cast<float>(i), berry);
    most = std::max(most, std::abs(after / before - 1));
  }
  CHECK(most < 0.004f);
}
