#include "models/bunch/paper/interaction.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::bunch {

// A pedicel is the stalk of one flower or berry.

namespace {

constexpr glm::vec3 down{0, -1, 0};
constexpr float degrees_per_radian = 180.0f / pi;

// The pose of a new part: the turtle's turns θ and φ (degrees), its heading after them, and the sphere at the end. The
// turtle's own turns make it, so that the probed and the drawn places agree bit for bit.
struct Pose {
  float theta = 0;
  float phi = 0;
  glm::vec3 heading{0};
  Sphere sphere;
};

// The part of a vector across a heading.
struct Across {
  glm::vec3 direction{0};  // unit
  float strength = 0;
};

// Searches for a direction in which a new part has room.
class Search {
 public:
  Search(const SphereGrid& structure, const lsystem::Turtle& turtle, const Newborn& newborn,
         const InteractionOptions& options)
      : structure_(structure), turtle_(turtle), newborn_(newborn), options_(options) {}

  // Turns a new part away from the parts that it touches until it is free (the paper's algorithm), or the limit of
  // tries or angle is reached.
  Room run() const {
    glm::vec3 heading = turtle_.heading;
    float turned = 0;
    for (std::uint32_t adjustments = 0;; ++adjustments) {
      // On the way the heading is enough; the turns are computed only where it seems free.
      Push push = probe(sphere_towards(heading));
      if (push.contacts == 0) {
        const Pose free = adjustments == 0 ? pose_for(0, 0) : pose_towards(heading);
        push = probe(free.sphere);
        if (push.contacts == 0) return room(true, with_sag(free), adjustments, turned);
        heading = free.heading;
      }
      const Pose last{0, 0, heading, sphere_towards(heading)};
      if (adjustments >= options_.tries) return room(false, last, adjustments, turned);
      if (!newborn_.pedicel && turned >= options_.delta) return room(false, last, adjustments, turned);

      // Equation 2: the push's parts along left and up, each times δ, are the turns; together they are one turn of
      // δ |F⊥| towards F⊥.
      Across way = part_across(heading, push.force);
      const float force = glm::length(push.force);
      if (way.strength <= 1e-3f * force) way = {part_across(heading, newborn_.tie).direction, force};
      const float turn = options_.delta * way.strength;
      if (!(turn > 0)) return room(false, last, adjustments, turned);
      turned += turn;
      heading = turned_by(heading, way.direction, turn);
    }
  }

 private:
  // The push of all other spheres on a sphere at the part's end.
  Push probe(const Sphere& sphere) const { return structure_.probe(sphere, newborn_.parent, newborn_.tie); }

  // The result of the search: whether room was found, the pose, and how often and far (degrees) the part was turned.
  Room room(bool found, const Pose& pose, std::uint32_t adjustments, float turned) const {
    return {found, pose.theta, pose.phi, pose.sphere, sphere_towards(turtle_.heading), adjustments, turned};
  }

  // The sphere at the end of the part in the direction `heading`, without turning the turtle.
  Sphere sphere_towards(const glm::vec3& heading) const {
    const float distance = newborn_.length + (newborn_.pedicel ? newborn_.radius : 0);
    return {turtle_.position + heading * distance, newborn_.radius};
  }

  // The pose after the turtle has turned by `theta` and pitched by `phi`, degrees.
  Pose pose_for(float theta, float phi) const {
    lsystem::Turtle turtle = turtle_;
    lsystem::turn(turtle, theta);
    lsystem::pitch(turtle, phi);
    turtle.position = lsystem::ahead(turtle, newborn_.length);
    const glm::vec3 centre = newborn_.pedicel ? lsystem::ahead(turtle, newborn_.radius) : turtle.position;
    return {theta, phi, turtle.heading, {centre, newborn_.radius}};
  }

  // The pose whose turns lead nearest to `heading`: exactly, unless the part may only turn in its plane.
  Pose pose_towards(const glm::vec3& heading) const {
    const float forward = glm::dot(heading, turtle_.heading);
    const float right = -glm::dot(heading, turtle_.left);
    const float theta = arc_tangent(right, forward) * degrees_per_radian;
    const float phi = newborn_.flat ? 0 : arc_sine(glm::dot(heading, turtle_.up)) * degrees_per_radian;
    return pose_for(theta, phi);
  }

  // The part of a vector at right angles to the heading; in the turtle's plane only, if the part is flat.
  Across part_across(const glm::vec3& heading, const glm::vec3& vector) const {
    glm::vec3 side = vector - heading * glm::dot(vector, heading);
    if (newborn_.flat) side -= turtle_.up * glm::dot(side, turtle_.up);
    const float strength = glm::length(side);
    return {strength > 0 ? side / strength : side, strength};
  }

  // The heading turned towards a direction at right angles to it, by so many degrees.
  static glm::vec3 turned_by(const glm::vec3& heading, const glm::vec3& direction, float degrees) {
    const SinCos angle = sincos_degrees(degrees);
    return heading * angle.cosine + direction * angle.sine;
  }

  // The free pose bent towards gravity, unless it would collide there. It does not count as a turn.
  Pose with_sag(const Pose& free) const {
    const Across pull = part_across(free.heading, down);
    if (options_.sag <= 0 || pull.strength <= 1e-6f) return free;
    const float upright = arc_tangent(pull.strength, glm::dot(free.heading, down)) * degrees_per_radian;
    const Pose lower = pose_towards(turned_by(free.heading, pull.direction, std::min(options_.sag, upright)));
    return probe(lower.sphere).contacts == 0 ? lower : free;
  }

  const SphereGrid& structure_;
  const lsystem::Turtle& turtle_;
  const Newborn& newborn_;
  const InteractionOptions& options_;
};

}  // namespace

// Looks for a direction in which a new part at the turtle's place touches no other (equation 2 of the paper).
Room find_room(const SphereGrid& structure, const lsystem::Turtle& turtle, const Newborn& newborn,
               const InteractionOptions& options) {
  return Search(structure, turtle, newborn, options).run();
}

}  // namespace panicle::bunch
