// What a fruit's surface has beyond its form: scar, seat and relief, as seen from the centre.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/bunch/fruit/berry_body.hpp"
#include "models/bunch/fruit/wrinkles.hpp"

namespace panicle::bunch {

class FruitSkin {
 public:
  explicit FruitSkin(Fruit fruit);

  // How far the surface lies in a direction (unit vector in unit space, tip +Y) over how far the free form does.
  float height(const glm::vec3& direction) const;

  float highest() const;  // no height is above this

  // Segments round the widest ring that show the relief, where `segments` do for a berry without any.
  std::uint32_t meridians(std::uint32_t segments) const;

 private:
  float bumps(const glm::vec3& direction) const;

  Fruit fruit_;
  Wrinkles leather_;
  std::vector<glm::vec3> bumps_;  // the middles of drupelets or tubercles, spread evenly
};

}  // namespace panicle::bunch
