#include "models/particles/ribs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/random.hpp"
#include "models/particles/rib_grid.hpp"

using namespace panicle;
using namespace panicle::particles;

namespace {

// A midrib in four pieces with a branch on each side of its second place.
Ribs fishbone() {
  return {{{0, 0, 0},
           {0, 0.25f, 0},
           {0, 0.5f, 0},
           {0, 0.75f, 0},
           {0, 1, 0},
           {0.3f, 0.7f, 0},
           {-0.3f, 0.7f, 0},
           {-0.4f, 0.9f, 0}},
          {-1, 0, 1, 2, 3, 2, 2, 6}};
}

}  // namespace

TEST_CASE("the nearest place on ribs, the way down them and its length follow from geometry") {
  const Ribs ribs = fishbone();
  const Ribs::Foot foot = ribs.nearest({0.1f, 0.3f, 0});
  CHECK(foot.at == 2);
  CHECK(foot.place.x == 0);
  CHECK(foot.place.y == doctest::Approx(0.3));
  CHECK(foot.distance == doctest::Approx(0.1));
  CHECK(ribs.length_below(foot) == doctest::Approx(0.3));
  CHECK(ribs.down(foot, 0.2f).y == doctest::Approx(0.1));
  CHECK(ribs.down(foot, 9) == ribs.places[0]);
  // From a branch round its junction and down the midrib.
  const Ribs::Foot tip = ribs.nearest({0.5f, 0.9f, 0});
  CHECK(tip.at == 5);
  CHECK(ribs.length_below(tip) == doctest::Approx(0.5 + std::sqrt(0.3 * 0.3 + 0.2 * 0.2)));
  CHECK(ribs.down(tip, std::sqrt(0.13f) + 0.1f).y == doctest::Approx(0.4));
}

TEST_CASE("ribs of one place alone are that place") {
  const Ribs ribs{{{0.2f, 0, 0}}, {-1}};
  const RibGrid grid(ribs, {-1, -1, 0}, {1, 1, 0});
  for (const Ribs::Foot& foot : {ribs.nearest({0.2f, 1, 0}), grid.nearest({0.2f, 1, 0})}) {
    CHECK(foot.at == 0);
    CHECK(foot.distance == doctest::Approx(1));
    CHECK(ribs.length_below(foot) == 0);
  }
}

TEST_CASE("places along ribs are no farther apart than the spacing") {
  const Ribs ribs = fishbone();
  const auto sampled = ribs.sampled(0.07f);
  CHECK(sampled[0] == ribs.places[0]);
  for (float t = 0; t <= 1; t += 0.01f) {
    float nearest = 9;
    for (const glm::vec3& place : sampled) nearest = std::min(nearest, glm::distance(place, glm::vec3(0, t, 0)));
    CHECK(nearest <= 0.0351f);
  }
}

TEST_CASE("the grid gives the same result as all pieces") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Ribs ribs{{{0, 0, 0}}, {-1}};
    for (std::uint64_t i = 1; i < 2 + 15 * seed; ++i) {
      ribs.next.push_back(random_integer(seed, 1, i, 0, static_cast<std::int32_t>(i) - 1));
      ribs.places.push_back({2 * random_unit(seed, 2, i) - 1, 2 * random_unit(seed, 3, i) - 1, 0});
    }
    const RibGrid grid(ribs, {-1, -1, 0}, {1, 1, 0});
    for (std::uint64_t k = 0; k < 300; ++k) {
      // Some outside its box.
      const glm::vec3 p(2.4f * random_unit(seed, 4, k) - 1.2f, 2.4f * random_unit(seed, 5, k) - 1.2f, 0);
      const Ribs::Foot found = grid.nearest(p), wanted = ribs.nearest(p);
      CHECK(found.at == wanted.at);
      CHECK(found.place == wanted.place);
    }
  }
}

TEST_CASE("ribs are lines: the first goes on, others begin their own") {
  const Ribs ribs = fishbone();
  const RibGrid grid(ribs, {-1, 0, 0}, {1, 1, 0});
  CHECK(grid.line_of(1) == 0);
  CHECK(grid.line_of(4) == 0);
  CHECK(grid.line_of(5) != 0);
  CHECK(grid.line_of(6) != grid.line_of(5));
  CHECK(grid.line_of(7) == grid.line_of(6));
  const Ribs::Foot along = grid.nearest_on(0, {0.3f, 0.7f, 0});
  CHECK(along.place.x == 0);
  CHECK(along.place.y == doctest::Approx(0.7));
}
