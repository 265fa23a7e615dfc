#include "foundation/rotation.hpp"

#include <doctest/doctest.h>

#include "foundation/golden_spiral.hpp"
#include "foundation/mathematics.hpp"

using namespace panicle;

namespace {

// A vector turned by a unit quaternion x y z w.
glm::vec3 turned(const glm::vec4& q, const glm::vec3& v) {
  const glm::vec3 axis(q), half = glm::cross(axis, v);
  return v + 2.0f * (q.w * half + glm::cross(axis, half));
}

}  // namespace

TEST_CASE("any_perpendicular returns a unit vector at right angles in every direction") {
  constexpr std::size_t count = 500;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 way = golden_sphere_point(i, count), side = any_perpendicular(way);
    CHECK(std::fabs(glm::dot(way, side)) < 1e-6f);
    CHECK(glm::length(side) == doctest::Approx(1));
  }
}

TEST_CASE("any_perpendicular is at right angles to the first axis, or to the second near the first") {
  CHECK(any_perpendicular({0, 0, 1}) == glm::vec3(-1, 0, 0));
  CHECK(any_perpendicular({0, 1, 0}) == glm::vec3(0, 0, -1));
  CHECK(any_perpendicular({0, -1, 0}) == glm::vec3(0, 0, 1));
  CHECK(axis_across({0.6f, 0.8f, 0}) == glm::vec3(0, 1, 0));
  CHECK(axis_across({0.6f, -0.8f, 0}, 0.7f) == glm::vec3(1, 0, 0));
  CHECK(axis_across({0.6f, 0.8f, 0}, 0.5f, {1, 0, 0}, {0, 0, 1}) == glm::vec3(0, 0, 1));
}

TEST_CASE("quaternion_of and turn_to return the rotation of a frame, whichever component is the largest") {
  constexpr std::size_t count = 60;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 up = golden_sphere_point(i, count), side = any_perpendicular(up);
    for (int k = 0; k < 12; ++k) {
      const SinCos turn = sincos_degrees(30.0f * static_cast<float>(k));
      const glm::vec3 front = turn.cosine * side + turn.sine * glm::cross(up, side);
      const glm::vec4 q = turn_to(up, front);
      CHECK(glm::length(q) == doctest::Approx(1));
      CHECK(glm::distance(turned(q, {0, 1, 0}), up) < 1e-5f);
      CHECK(glm::distance(turned(q, {0, 0, 1}), front) < 1e-5f);
      CHECK(glm::distance(q, quaternion_of({glm::cross(up, front), up, front})) < 1e-5f);
    }
  }
}
