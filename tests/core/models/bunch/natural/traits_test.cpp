#include "models/bunch/natural/traits.hpp"

#include <doctest/doctest.h>

#include "models/bunch/natural/stages.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

Traits at(float age, RipeningInputs berry = {{{}, {0, -1, 0}, 8, 9, 0, 1}, 0.3f, 0.5f, true}, std::uint32_t bunch = 0) {
  Flower flower = flower_on(0, {0, -1, 0}, 7);
  flower.bunch = bunch;
  return traits_of(berry, flower, {age, 1, 1}, 3);
}

}  // namespace

TEST_CASE("a berry's traits are its body's widths in metres and its stage") {
  const Traits ripe = at(100);
  CHECK(ripe.width == doctest::Approx(0.016));
  CHECK(ripe.length == doctest::Approx(0.018));
  CHECK(ripe.turned > 0.9f);
  CHECK(ripe.set == 1);
  CHECK(ripe.shrivel == 0);
  CHECK(at(125).shrivel > 0.3f);
  CHECK(at(50).turned == 0);
}

TEST_CASE(
    "a flower that will not set stays a flower; light hastens colouring; the second bunch has its own random values") {
  RipeningInputs flower{{{}, {0, -1, 0}, 1, 1, 0, 1}, 0.3f, 0.5f, false};
  CHECK(at(11, flower).set == 0);
  RipeningInputs lit{{{}, {0, -1, 0}, 8, 8, 0, 1}, 0.3f, 1, true}, shaded = lit;
  shaded.exposure = 0;
  bool sooner = false;
  for (float age = 60; age < 95; age += 5) {
    CHECK(at(age, lit).turned >= at(age, shaded).turned);
    sooner |= at(age, lit).turned > at(age, shaded).turned;
  }
  CHECK(sooner);
  bool unlike = false;
  for (float age = 60; age < 95; age += 5) unlike |= at(age, lit, 0).turned != at(age, lit, 1).turned;
  CHECK(unlike);
}

TEST_CASE("seeds are whole numbers from none to four, by a random value") {
  for (float a = 0; a < 1; a += 0.1f)
    for (float b = 0; b < 1; b += 0.1f) {
      const float seeds = seeds_of(a, b, 4);
      CHECK(seeds == static_cast<float>(static_cast<int>(seeds)));
      CHECK(seeds >= 0);
      CHECK(seeds <= 4);
      CHECK(seeds_of(a + 0.1f, b, 4) >= seeds);
    }
  CHECK(seeds_of(0, 0, 4) == 0);
  CHECK(seeds_of(1, 1, 4) == 4);
  CHECK(seeds_of(1, 1, 2) == 2);
  CHECK(seeds_of(1, 1, 0) == 0);
}
