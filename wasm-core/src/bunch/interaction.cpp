#include "bunch/interaction.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::bunch {
namespace {

constexpr glm::vec3 down{0, -1, 0};
constexpr float degrees_per_radian = 180.0f / pi;

// One way the newborn could grow. The sphere is placed by the turtle's own turns, so that what is probed and what is
// drawn agree bit for bit.
struct Pose {
  float theta = 0;
  float phi = 0;
  glm::vec3 heading{0};
  Sphere sphere;
};

Pose pose(const lsystem::Turtle& origin, const Newborn& newborn, float theta, float phi) {
  lsystem::Turtle turtle = origin;
  lsystem::turn(turtle, theta);
  lsystem::pitch(turtle, phi);
  turtle.position = lsystem::ahead(turtle, newborn.length);
  const glm::vec3 centre = newborn.pedicel ? lsystem::ahead(turtle, newborn.radius) : turtle.position;
  return {theta, phi, turtle.heading, {centre, newborn.radius}};
}

// The pose whose heading is `from` bent by `degrees` towards `aim`, as far as `aim` itself at the most.
// `strength` is the length of aim's part across the heading.
struct Across {
  glm::vec3 direction{0};
  float strength = 0;
};

Across across(const lsystem::Turtle& turtle, const Newborn& newborn, const glm::vec3& heading, const glm::vec3& aim) {
  glm::vec3 side = aim - heading * glm::dot(aim, heading);
  if (newborn.flat) side -= turtle.up * glm::dot(side, turtle.up);
  const float strength = glm::length(side);
  return {strength > 0 ? side / strength : side, strength};
}

Pose bent(const lsystem::Turtle& turtle, const Newborn& newborn, const Pose& from, const glm::vec3& direction,
          float degrees) {
  const SinCos angle = sincos_degrees(degrees);
  const glm::vec3 heading = from.heading * angle.cosine + direction * angle.sine;
  const float forward = glm::dot(heading, turtle.heading);
  const float right = -glm::dot(heading, turtle.left);
  const float theta = arc_tangent(right, forward) * degrees_per_radian;
  const float phi = newborn.flat ? 0 : arc_sine(glm::dot(heading, turtle.up)) * degrees_per_radian;
  return pose(turtle, newborn, theta, phi);
}

// Bends a free pose towards gravity, unless it would collide there. Not counted in the accumulated rotation.
Pose sagged(const SphereGrid& structure, const lsystem::Turtle& turtle, const Newborn& newborn, const Pose& free,
            float sag) {
  const Across pull = across(turtle, newborn, free.heading, down);
  if (sag <= 0 || pull.strength <= 1e-6f) return free;
  const float upright = arc_tangent(pull.strength, glm::dot(free.heading, down)) * degrees_per_radian;
  const Pose lower = bent(turtle, newborn, free, pull.direction, std::min(sag, upright));
  return structure.probe(lower.sphere, newborn.parent, newborn.tie).contacts == 0 ? lower : free;
}

}  // namespace

Room find_room(const SphereGrid& structure, const lsystem::Turtle& turtle, const Newborn& newborn,
               const InteractionOptions& options) {
  Pose current = pose(turtle, newborn, 0, 0);
  float turned = 0;
  for (std::uint32_t adjustments = 0;; ++adjustments) {
    const Push push = structure.probe(current.sphere, newborn.parent, newborn.tie);
    if (push.contacts == 0) {
      const Pose resting = sagged(structure, turtle, newborn, current, options.sag);
      return {true, resting.theta, resting.phi, resting.sphere};
    }
    if (adjustments >= options.tries) return {};
    if (!newborn.pedicel && turned >= options.delta) return {};

    // Equation 2: the push's parts along left and up, each times δ, are the turns; together they are one turn of
    // δ |F⊥| towards F⊥.
    Across way = across(turtle, newborn, current.heading, push.force);
    const float force = glm::length(push.force);
    if (way.strength <= 1e-3f * force) {
      way = across(turtle, newborn, current.heading, newborn.tie);
      way.strength = force;
    }
    const float turn = options.delta * way.strength;
    if (!(turn > 0)) return {};
    turned += turn;
    current = bent(turtle, newborn, current, way.direction, turn);
  }
}

}  // namespace panicle::bunch
