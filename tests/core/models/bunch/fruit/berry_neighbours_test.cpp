#include "models/bunch/fruit/berry_neighbours.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "foundation/random.hpp"

using namespace panicle;
using namespace panicle::bunch;

TEST_CASE("the grid finds the pairs that looking at all would find, in their order") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    std::vector<Ball> balls(static_cast<std::size_t>(random_integer(seed, 0, 0, 0, 120)));
    const float stretch = seed % 4 == 0 ? 1000.0f : 1.0f;  // a few far away
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const auto unit = [&](std::uint64_t stream) { return random_unit(seed, stream, i) - 0.5f; };
      balls[i].centre =
          glm::vec3(unit(1), seed % 3 == 0 ? 0.0f : unit(2), unit(3)) * (i % 9 == 0 ? 10 * stretch : 10.0f);
      balls[i].radius = 0.3f + unit(4) * 0.6f * (i % 7 == 0 ? 4.0f : 1.0f);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
    for (std::uint32_t a = 0; a < balls.size(); ++a) {
      for (std::uint32_t b = a + 1; b < balls.size(); ++b) {
        const glm::vec3 way = balls[b].centre - balls[a].centre;
        const float reach = balls[a].radius + balls[b].radius;
        if (glm::dot(way, way) <= reach * reach) expected.emplace_back(a, b);
      }
    }
    CHECK(touching_pairs(balls) == expected);
  }
}

TEST_CASE("balls that are not finite touch nothing") {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  const std::vector<Ball> balls = {{{0, 0, 0}, 1}, {{infinite, 0, 0}, 1}, {{1, 0, 0}, 1}, {{0, 0, 0}, infinite}};
  const auto pairs = touching_pairs(balls);
  REQUIRE(pairs.size() == 1);
  CHECK(pairs[0] == std::pair<std::uint32_t, std::uint32_t>(0, 2));
  CHECK(touching_pairs({}).empty());
}
