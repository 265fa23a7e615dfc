// Where particles may start: an area in the plane z = 0 or a volume, as dense as it says.
#pragma once

#include <glm/vec3.hpp>

namespace panicle::particles {

class Region {
 public:
  virtual ~Region() = default;
  // A box that holds it; z = 0 in both for an area.
  virtual glm::vec3 low() const = 0;
  virtual glm::vec3 high() const = 0;
  virtual bool contains(const glm::vec3& p) const = 0;
  // How dense particles are at a place inside, in (0, 1]: by light, for instance.
  virtual float density(const glm::vec3&) const { return 1; }

  bool flat() const { return low().z == high().z; }
};

}  // namespace panicle::particles
