// A clipping volume: a box, an ellipsoid, a cylinder, a cone or a closed mesh, with size, rotation and centre.
#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "spatial/closed_surface.hpp"
#include "spatial/solid.hpp"

namespace panicle {

class Volume {
 public:
  enum class Kind : std::uint8_t { box, sphere, ellipsoid, cylinder, cone, mesh };

  // `size` is that of the box which it fills before it is turned about its centre, above 0 each way; a sphere's is the
  // first alone. Cylinder and cone stand upright in it, the cone on its base. A mesh is stretched to the box, in any
  // unit; its inside is that of Solid, which has the budget. `rotation` is normalised.
  Volume(Kind kind, const glm::vec3& centre, const glm::vec3& size, const glm::quat& rotation, const Surface& mesh = {},
         std::shared_ptr<QueryBudget> budget = std::make_shared<QueryBudget>());

  bool contains(const glm::vec3& p) const;
  // The length of the way from a place inside, along a unit vector, that stays inside: 0 from outside, at most `most`.
  // Where it meets the surface, the result is less by a hundred-thousandth of the size, so that its end is inside after
  // any rounding; ways of a concave mesh end where they first leave it.
  float reach(const glm::vec3& from, const glm::vec3& way, float most) const;
  const glm::vec3& centre() const { return centre_; }

 private:
  // Rotates a vector into the volume's own frame.
  glm::vec3 to_local(const glm::vec3& v) const { return to_local_rotation_ * v; }
  bool contains_local(const glm::vec3& p) const;
  float exit_distance(const glm::vec3& p, const glm::vec3& way, float most) const;

  Kind kind_;
  glm::vec3 centre_, half_;
  glm::quat to_local_rotation_;
  float margin_;
  std::shared_ptr<const Solid> solid_;  // of a mesh
};

}  // namespace panicle
