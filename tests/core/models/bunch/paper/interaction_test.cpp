#include "models/bunch/paper/interaction.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

using namespace panicle;
using namespace panicle::bunch;

namespace {

constexpr float degrees = 180 / pi;

// A wall of spheres in front of a turtle at the origin that looks down, a little to its right.
SphereGrid wall(float radius) {
  SphereGrid structure(radius);
  for (int k = 0; k < 6; ++k) structure.add({{0.2f, -20, static_cast<float>(k - 3)}, radius});
  return structure;
}

float turned(const Room& room) {
  const SinCos theta = sincos_degrees(room.theta), phi = sincos_degrees(room.phi);
  return std::acos(theta.cosine * phi.cosine) * degrees;
}

}  // namespace

TEST_CASE("an internode stops once it has turned by δ in all; a pedicel goes on") {
  // Free only from about 24° on, and the first push turns by less.
  Newborn newborn;
  newborn.length = 20;
  newborn.radius = 2;
  newborn.tie = {1, 0, 0};
  const SphereGrid structure = wall(6);
  CHECK(!find_room(structure, {}, newborn, {15, 50, 0}).found);
  const Room wide = find_room(structure, {}, newborn, {20, 50, 0});
  REQUIRE(wide.found);
  CHECK(turned(wide) > 20);
  newborn.pedicel = true;
  newborn.length = 18;
  const Room pedicel = find_room(structure, {}, newborn, {15, 50, 0});
  REQUIRE(pedicel.found);
  CHECK(turned(pedicel) > 20);
}

TEST_CASE("no internode tries more often than t") {
  Newborn newborn;
  newborn.pedicel = true;
  newborn.length = 18;
  newborn.radius = 2;
  newborn.tie = {1, 0, 0};
  const SphereGrid structure = wall(6);
  CHECK(find_room(structure, {}, newborn, {15, 50, 0}).found);
  CHECK(!find_room(structure, {}, newborn, {15, 1, 0}).found);
}

TEST_CASE("free internodes sag by the given angle, and never past vertical") {
  const SphereGrid empty(5);
  for (const float upright : {90.0f, 30.0f, 1.0f}) {
    lsystem::Turtle turtle;
    lsystem::turn(turtle, upright);
    Newborn newborn;
    newborn.length = 20;
    newborn.radius = 2;
    const Room room = find_room(empty, turtle, newborn, {15, 50, 5});
    REQUIRE(room.found);
    const float angle = std::acos(-room.sphere.centre.y / glm::length(room.sphere.centre)) * degrees;
    CHECK(angle == doctest::Approx(std::fmax(0.0f, upright - 5)).epsilon(0.02));
    CHECK(room.sphere.centre.x * glm::dot(turtle.heading, glm::vec3(1, 0, 0)) >= -1e-3f);
  }
}

TEST_CASE("a question without phi is answered by a turn in its own plane, or not at all") {
  // Above the newborn, so that the nearest way out is downwards.
  SphereGrid structure(6);
  structure.add({{0.5f, -20, 3}, 6});
  Newborn newborn;
  newborn.pedicel = true;
  newborn.length = 18;
  newborn.radius = 2;
  newborn.tie = {1, 0, 0};
  const Room free = find_room(structure, {}, newborn, {15, 50, 0});
  REQUIRE(free.found);
  CHECK(std::abs(free.phi) > 5);
  newborn.flat = true;
  const lsystem::Turtle turtle;
  const Room flat = find_room(structure, turtle, newborn, {15, 50, 0});
  REQUIRE(flat.found);
  CHECK(flat.phi == 0);
  CHECK(std::abs(glm::dot(flat.sphere.centre, turtle.up)) < 1e-4f);
  // Sag would lead out of the plane of a turtle that lies on its side.
  lsystem::Turtle level;
  lsystem::pitch(level, 90);
  const Room sagged = find_room(SphereGrid(5), level, newborn, {15, 50, 5});
  REQUIRE(sagged.found);
  CHECK(sagged.phi == 0);
}

TEST_CASE("no internode sags into the structure") {
  lsystem::Turtle turtle;
  lsystem::turn(turtle, 90);
  Newborn newborn;
  newborn.pedicel = true;
  newborn.length = 18;
  newborn.radius = 2;
  const Room straight = find_room(SphereGrid(3), turtle, newborn, {15, 50, 0});
  const glm::vec3 ahead = straight.sphere.centre;
  SphereGrid structure(3);
  structure.add({ahead - glm::vec3(0, 5.1f, 0), 3});  // just clear of it
  const Room held = find_room(structure, turtle, newborn, {15, 50, 10});
  REQUIRE(held.found);
  CHECK(glm::length(held.sphere.centre - ahead) < 1e-4f);
  CHECK(find_room(SphereGrid(3), turtle, newborn, {15, 50, 10}).sphere.centre.y < ahead.y - 1);
}
