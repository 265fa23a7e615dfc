#include "models/bunch/berry/wrinkles.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/random.hpp"

using namespace panicle;
using namespace panicle::bunch;

TEST_CASE("the slope is the field's change along the sphere") {
  const Wrinkles wrinkles(3, 6);
  constexpr float step = 1e-3f;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const glm::vec3 at = random_direction(1, 1, i);
    const glm::vec3 sideways = glm::normalize(glm::cross(at, random_direction(1, 2, i)));
    const Wrinkles::Value value = wrinkles.at(at);
    const float ahead = wrinkles.at(glm::normalize(at + sideways * step)).value;
    const float behind = wrinkles.at(glm::normalize(at - sideways * step)).value;
    CHECK(glm::dot(value.slope, at) == doctest::Approx(0).epsilon(1e-4));
    CHECK(std::fabs(glm::dot(value.slope, sideways) - (ahead - behind) / (2 * step)) < 0.01f);
  }
}

TEST_CASE("a field lies about 0, seldom beyond 1.5, and fields of other numbers differ") {
  const Wrinkles one(0, 6), other(1, 6);
  double sum = 0, square = 0, product = 0;
  constexpr int count = 4000;
  for (std::uint64_t i = 0; i < count; ++i) {
    const glm::vec3 at = random_direction(2, 1, i);
    const double a = one.at(at).value, b = other.at(at).value;
    sum += a / count;
    square += a * a / count;
    product += a * b / count;
  }
  CHECK(std::fabs(sum) < 0.3);
  CHECK(square > 0.5);
  CHECK(square < 1.5);
  CHECK(std::fabs(product) < 0.3 * square);
}
