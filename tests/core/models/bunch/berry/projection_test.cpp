#include "models/bunch/berry/pressing/projection.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

using namespace panicle;
using namespace panicle::bunch;

namespace {

// A number in −1 … 1 from a counter.
float spread(std::uint32_t k) {
  k = (k ^ (k >> 16)) * 0x45d9f3bu;
  k = (k ^ (k >> 16)) * 0x45d9f3bu;
  return static_cast<float>((k ^ (k >> 16)) & 0xffff) / 32767.5f - 1;
}

glm::vec3 some_direction(std::uint32_t k) { return glm::normalize(glm::vec3(spread(k), spread(k + 1), spread(k + 2))); }

// A point of the body's surface: the unit sphere's, stretched along the
// direction.
glm::vec3 surface_point(const BerryBody& body, glm::vec3 on_sphere) {
  const float along = glm::dot(on_sphere, body.direction);
  return body.centre + body.half_width * (on_sphere - along * body.direction) +
         body.half_length * along * body.direction;
}

BerryBody some_body(std::uint32_t k) {
  return {{spread(k + 3), spread(k + 4), spread(k + 5)},
          some_direction(k + 6),
          1.2f + spread(k + 9),
          1.3f + spread(k + 10)};
}

}  // namespace

TEST_CASE("a view is orthonormal and right-handed from everywhere") {
  for (std::uint32_t k = 0; k < 100; ++k) {
    const glm::vec3 towards = k == 0 ? glm::vec3(0, 3, 0) : k == 1 ? glm::vec3(0, -2, 0) : 5.0f * some_direction(7 * k);
    const View view = view_from(towards);
    CHECK(glm::dot(view.towards, glm::normalize(towards)) == doctest::Approx(1));
    CHECK(glm::length(view.right) == doctest::Approx(1));
    CHECK(glm::length(glm::cross(view.right, view.up) - view.towards) < 1e-5f);
  }
  CHECK(view_from({0, 0, 1}).right.x == 1);
  CHECK(view_from({1, 0, 0}).right.z == -1);
}

TEST_CASE(
    "the outline holds every point of the surface and is touched by "
    "some; the surface seen lies on the body") {
  for (std::uint32_t k = 0; k < 60; ++k) {
    CAPTURE(k);
    const BerryBody body = some_body(20 * k);
    const View view = view_from(some_direction(1000 + 7 * k));
    const ProjectedBerry seen = project(body, view);
    float furthest = 0, widest = 0, highest = 0, longest = 0;
    for (int i = 0; i < 40; ++i) {
      for (int j = 0; j < 80; ++j) {
        const SinCos polar = sincos_degrees(4.5f * static_cast<float>(i) + 2),
                     round = sincos_degrees(4.5f * static_cast<float>(j));
        const glm::vec3 point = surface_point(body, {polar.sine * round.cosine, polar.cosine, polar.sine * round.sine});
        const glm::vec2 away = glm::vec2(glm::dot(point, view.right), glm::dot(point, view.up)) - seen.centre;
        furthest = std::max(furthest, seen.level(away));
        widest = std::max(widest, std::abs(away.x));
        highest = std::max(highest, std::abs(away.y));
        longest = std::max(longest, glm::length(away));
        const float plane = seen.depth + glm::dot(seen.slope, away);
        const float bulge = seen.thickness * std::sqrt(std::max(0.0f, 1 - seen.level(away)));
        CHECK(std::abs(std::abs(glm::dot(point, view.towards) - plane) - bulge) < 0.02f);
      }
    }
    CHECK(furthest < 1.0005f);
    CHECK(furthest > 0.99f);
    CHECK(widest == doctest::Approx(seen.half.x).epsilon(0.01));
    CHECK(highest == doctest::Approx(seen.half.y).epsilon(0.01));
    CHECK(longest == doctest::Approx(seen.outer).epsilon(0.01));
  }
}

TEST_CASE("the disc maps onto the outline evenly") {
  for (std::uint32_t k = 0; k < 60; ++k) {
    const ProjectedBerry seen = project(some_body(20 * k), view_from(some_direction(7 * k)));
    for (int degrees = 0; degrees < 360; degrees += 15) {
      const SinCos turn = sincos_degrees(static_cast<float>(degrees));
      CHECK(seen.level(seen.on_disc({turn.cosine, turn.sine})) == doctest::Approx(1).epsilon(1e-3));
    }
    const glm::vec2 x = seen.on_disc({1, 0}), y = seen.on_disc({0, 1});
    CHECK(seen.area() == doctest::Approx(pi * std::abs(x.x * y.y - x.y * y.x)).epsilon(1e-3));
  }
  CHECK(project({{0, 0, 0}, {0, -1, 0}, 3, 3}, {}).area() == doctest::Approx(9 * pi));
}

TEST_CASE("a berry of size 0 gives finite numbers") {
  const ProjectedBerry seen = project({{1, 2, 3}, {0, -1, 0}, 0, 0}, {});
  CHECK(std::isfinite(seen.uu + seen.uv + seen.vv + seen.thickness + seen.area()));
}
