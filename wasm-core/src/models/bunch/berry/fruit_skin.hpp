// The surface details of a fruit, beyond its form: scar, seat and relief, as seen from the centre.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/bunch/berry/berry_body.hpp"
#include "models/bunch/berry/wrinkles.hpp"

namespace panicle::bunch {

class FruitSkin {
 public:
  explicit FruitSkin(Fruit fruit, float relief = 1);

  // The distance of the surface in a direction (unit vector in unit space, tip +Y) over that of the free form.
  float height(const glm::vec3& direction) const;

  float highest() const;  // no height is above this

  // How deep a drying berry folds, 0 … 1: rinds keep their form.
  float folds() const;

  // The number of segments round the widest ring that resolves the relief, for a berry that needs `segments` without
  // relief.
  std::uint32_t meridians(std::uint32_t segments) const;

 private:
  float grown_height(const glm::vec3& direction) const;
  float bumps(const glm::vec3& direction) const;

  Fruit fruit_;
  float relief_;  // 0 … 1: strength of the relief
  Wrinkles leather_;
  std::vector<glm::vec3> bumps_;  // the middles of drupelets or tubercles, spread evenly
};

}  // namespace panicle::bunch
