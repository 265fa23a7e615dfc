#include "lsystem/turtle.hpp"

#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::lsystem {
namespace {

// One step of Newton's method for 1 / |v| from 1: a vector that is off unit length by e comes back off by e².
glm::vec3 unit_again(const glm::vec3& v) { return v * (1.5f - 0.5f * glm::dot(v, v)); }

}  // namespace

// Each turn leaves its axis alone, rotates one of the other two vectors and takes the third as a cross product: so
// errors of length and of angle are corrected where they arise instead of adding up along a chain.

void turn(Turtle& turtle, float theta) {
  const auto [sine, cosine] = sincos_degrees(theta);
  turtle.heading = unit_again(turtle.heading * cosine - turtle.left * sine);
  turtle.left = glm::cross(turtle.up, turtle.heading);
}

void pitch(Turtle& turtle, float phi) {
  const auto [sine, cosine] = sincos_degrees(phi);
  turtle.heading = unit_again(turtle.heading * cosine + turtle.up * sine);
  turtle.up = glm::cross(turtle.heading, turtle.left);
}

void roll(Turtle& turtle, float psi) {
  const auto [sine, cosine] = sincos_degrees(psi);
  turtle.left = unit_again(turtle.left * cosine - turtle.up * sine);
  turtle.up = glm::cross(turtle.heading, turtle.left);
}

glm::vec3 ahead(const Turtle& turtle, float distance) { return turtle.position + turtle.heading * distance; }

}  // namespace panicle::lsystem
