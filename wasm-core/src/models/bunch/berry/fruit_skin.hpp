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

  // How far the surface lies in a direction (unit vector in unit space, tip +Y) over how far the free form does.
  float height(const glm::vec3& direction) const;

  float highest() const;  // no height is above this

  // How deep a berry folds that dries, 0 … 1: rinds keep their form.
  float folds() const;

  // Segments round the widest ring that show the relief, where `segments` do for a berry without any.
  std::uint32_t meridians(std::uint32_t segments) const;

 private:
  float grown_height(const glm::vec3& direction) const;
  float bumps(const glm::vec3& direction) const;

  Fruit fruit_;
  float relief_;  // 0 … 1: how far all of this has come out
  Wrinkles leather_;
  std::vector<glm::vec3> bumps_;  // the middles of drupelets or tubercles, spread evenly
};

}  // namespace panicle::bunch
