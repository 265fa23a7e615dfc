#include "lsystem/turtle/turtle.hpp"

#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::lsystem {

// The turtle is the moving pen that draws a string.

namespace {

// Restores the length of a vector that is nearly a unit vector: one step of Newton's method for 1 / |v| from 1. A
// deviation e becomes about e².
glm::vec3 unit_again(const glm::vec3& v) { return v * (1.5f - 0.5f * glm::dot(v, v)); }

}  // namespace

// Each turn leaves its axis alone, rotates one of the other two vectors and takes the third as a cross product: so
// errors of length and of angle are corrected where they arise instead of adding up along a chain.

// Turns the turtle about its up axis by degrees.
// Each rotation leaves its axis alone, rotates one of the other two vectors and takes the third as a cross product: so
// errors of length and of angle are corrected where they arise instead of adding up along a chain.
void turn(Turtle& turtle, float theta) {
  const auto [sine, cosine] = sincos_degrees(theta);
  turtle.heading = unit_again(turtle.heading * cosine - turtle.left * sine);
  turtle.left = glm::cross(turtle.up, turtle.heading);
}

// Turns the turtle about its left axis by degrees.
void pitch(Turtle& turtle, float phi) {
  const auto [sine, cosine] = sincos_degrees(phi);
  turtle.heading = unit_again(turtle.heading * cosine + turtle.up * sine);
  turtle.up = glm::cross(turtle.heading, turtle.left);
}

// Turns the turtle about its heading by degrees.
void roll(Turtle& turtle, float psi) {
  const auto [sine, cosine] = sincos_degrees(psi);
  turtle.left = unit_again(turtle.left * cosine - turtle.up * sine);
  turtle.up = glm::cross(turtle.heading, turtle.left);
}

// Rolls the turtle until its left axis is horizontal (The Algorithmic Beauty of Plants, section 1.6.4): L = V × H / |V
// × H|, V straight up.
void level(Turtle& turtle) {
  const glm::vec3 left = glm::cross(glm::vec3(0, 1, 0), turtle.heading);
  const float length = glm::length(left);
  if (length < 1e-6f) return;
  turtle.left = left / length;
  turtle.up = glm::cross(turtle.heading, turtle.left);
}

// Bends the turtle towards its tropism T (The Algorithmic Beauty of Plants, section 2.3.3): a rotation about H × T by e
// · |H × T| radians, e the elasticity.
void bend(Turtle& turtle) {
  const glm::vec3 torque = glm::cross(turtle.heading, turtle.tropism);
  const float length = glm::length(torque);
  if (turtle.elasticity == 0 || length < 1e-9f) return;
  const glm::vec3 axis = torque / length;
  const auto turning = sincos_degrees(turtle.elasticity * length * 57.29577951f);
  const float sine = turning.sine, cosine = turning.cosine;
  const auto turned = [&](const glm::vec3& v) {
    return v * cosine + glm::cross(axis, v) * sine + axis * (glm::dot(axis, v) * (1 - cosine));
  };
  turtle.heading = unit_again(turned(turtle.heading));
  turtle.left = turned(turtle.left);
  turtle.left = glm::normalize(turtle.left - turtle.heading * glm::dot(turtle.heading, turtle.left));
  turtle.up = glm::cross(turtle.heading, turtle.left);
}

// Turns the turtle to a heading of any length; 0 leaves it as it is. The up axis becomes as near to `up` as the heading
// allows.
void head_for(Turtle& turtle, const glm::vec3& heading, const glm::vec3& up) {
  const float length = glm::length(heading);
  if (length == 0) return;
  const glm::vec3 to = heading / length;
  // Without an up axis, the old one is preserved as far as the new heading allows; where it does not, the left one is.
  const bool given = up != glm::vec3(0);
  glm::vec3 left = glm::cross(given ? up : turtle.up, to);
  if (glm::dot(left, left) < 1e-12f) left = turtle.left - to * glm::dot(to, turtle.left);
  if (glm::dot(left, left) < 1e-12f) left = glm::cross(turtle.heading, to);
  turtle.heading = to;
  turtle.left = glm::normalize(left);
  turtle.up = glm::cross(to, turtle.left);
}

// The point at a distance along the heading.
glm::vec3 ahead(const Turtle& turtle, float distance) { return turtle.position + turtle.heading * distance; }

}  // namespace panicle::lsystem
