#include "models/bunch/natural/settling/spreading.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "models/bunch/natural/settling/sagging.hpp"

using namespace panicle;
using namespace panicle::bunch;

namespace {

const std::vector<Branch> one_node{{{0, 0, 0}, {0, -100, 0}, -1, 1, 0}};

Swelling berry_towards(const glm::vec3& way, float half = 8) {
  Swelling berry;
  berry.heading = glm::normalize(way);
  berry.stalk = 8;
  berry.half_width = berry.half_length = half;
  return berry;
}

std::vector<glm::vec3> leans_of(const std::vector<Swelling>& berries) {
  return spread(one_node, berries, std::vector<glm::quat>(1, glm::quat(1, 0, 0, 0)));
}

glm::vec3 leaning(const Swelling& berry, const glm::vec3& lean) { return drooping(berry.heading, 1) + lean; }

}  // namespace

TEST_CASE(
    "two that would hang in one place lean apart, each as far; their "
    "pedicels keep their length") {
  const std::vector<Swelling> two{berry_towards({1, 0, 0.3f}), berry_towards({1, 0, -0.3f})};
  const auto leans = leans_of(two);
  CHECK(leans[0].z > 0.05f);
  CHECK(leans[0].z == doctest::Approx(-leans[1].z));
  for (std::size_t i = 0; i < 2; ++i) CHECK(glm::length(leaning(two[i], leans[i])) == doctest::Approx(1));
}

TEST_CASE(
    "of two, one above the other, neither is lifted to speak of, and one "
    "alone leans a little down") {
  const std::vector<Swelling> two{berry_towards({1, 0.6f, 0}), berry_towards({1, -0.1f, 0})};
  const auto leans = leans_of(two);
  for (const glm::vec3& lean : leans) CHECK(lean.y <= 0.02f);
  const auto alone = leans_of({berry_towards({1, 0, 0})});
  CHECK(alone[0].y < -0.01f);
}

TEST_CASE("those with room lean alike") {
  const std::vector<Swelling> apart{berry_towards({1, 0, 0}), berry_towards({-1, 0, 0})};
  const auto leans = leans_of(apart);
  CHECK(leans[0].x == doctest::Approx(-leans[1].x));
  CHECK(leans[0].x == doctest::Approx(leans_of({apart[0]})[0].x));
}

TEST_CASE("a shot berry is displaced, and displaces no other") {
  std::vector<Swelling> two{berry_towards({1, 0, 0.2f}), berry_towards({1, 0, -0.2f}, 1.5f)};
  const auto leans = leans_of(two);
  CHECK(std::abs(leans[1].z) > 20 * std::abs(leans[0].z - leans_of({two[0]})[0].z));
}

TEST_CASE("berries that join late do not lean, and others do not lean away from them") {
  std::vector<Swelling> two{berry_towards({1, 0, 0.3f}), berry_towards({1, 0, -0.3f})};
  two[1].late = true;
  const auto leans = leans_of(two);
  CHECK(leans[1] == glm::vec3(0));
  CHECK(leans[0] == leans_of({two[0]})[0]);
}
