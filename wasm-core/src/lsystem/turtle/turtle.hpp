// The turtle: a position and an orthonormal frame that turns, rolls and moves.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace panicle::lsystem {

// Where the turtle is. Heading, left and up are of unit length, heading × left = up.
struct Turtle {
  glm::vec3 position{0};
  glm::vec3 heading{0, -1, 0};
  glm::vec3 left{-1, 0, 0};
  glm::vec3 up{0, 0, -1};
  float width = 1;
  std::int32_t line = -1;  // the last line drawn on the way here, −1 at the root
  std::int32_t colour = 1;
  float size = 1;  // scale of drawing, without widths
  float elasticity = 0;
  glm::vec3 tropism{0, -1, 0};
};

// The turtle's turns, for models that must predict its path: bit for bit as `+`, `&` and `/`. Degrees, clockwise seen
// against the axis: +θ takes the heading towards −left, &φ towards +up, /ψ takes left towards −up. Multiples of 90° are
// exact, and the frame stays orthonormal to rounding however long the chain.
void turn(Turtle& turtle, float theta);  // +(θ)
void pitch(Turtle& turtle, float phi);   // &(φ)
void roll(Turtle& turtle, float psi);    // /(ψ)
void level(Turtle& turtle);              // $: rolls until the left axis lies level
void bend(Turtle& turtle);               // after a line: towards the tropism, by the elasticity
void head_for(Turtle& turtle, const glm::vec3& heading, const glm::vec3& up);  // @R; `up` 0: the shortest way
glm::vec3 ahead(const Turtle& turtle, float distance);                         // where F(distance) or S(distance) ends

}  // namespace panicle::lsystem
