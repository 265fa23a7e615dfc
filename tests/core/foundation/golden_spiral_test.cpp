#include "foundation/golden_spiral.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>

using namespace panicle;

TEST_CASE("points of the golden disc are within it, evenly by area") {
  constexpr std::size_t count = 400;
  glm::vec2 sum(0);
  std::size_t inner = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec2 place = golden_disc_point(i, count);
    CHECK(glm::length(place) < 1);
    sum += place;
    inner += glm::length(place) < 0.5f;
  }
  CHECK(inner == count / 4);
  CHECK(glm::length(sum) / count < 0.01f);
}

TEST_CASE("points of the golden sphere have unit length and keep apart") {
  constexpr std::size_t count = 200;
  glm::vec3 sum(0);
  float nearest = 2;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 place = golden_sphere_point(i, count);
    CHECK(glm::length(place) == doctest::Approx(1));
    sum += place;
    for (std::size_t k = 0; k < i; ++k)
      nearest = std::min(nearest, glm::distance(place, golden_sphere_point(k, count)));
  }
  CHECK(glm::length(sum) / count < 0.01f);
  CHECK(nearest > 0.15f);  // as a square grid of as many points has 0.25
}
