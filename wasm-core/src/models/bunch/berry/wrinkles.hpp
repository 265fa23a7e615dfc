// A smooth field on the sphere without any order, for folds and relief.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace panicle::bunch {

// A sum of waves, about 0 and seldom beyond ±1.5. The waves run more across the axis (Y) than along it, like the folds
// of a drying berry.
class Wrinkles {
 public:
  // `which` numbers the field: fields of different numbers are independent. Crests are about 2π / pitch radians apart.
  Wrinkles(std::uint64_t which, float pitch);

  struct Value {
    float value;
    glm::vec3 slope;  // along the sphere
  };
  Value at(const glm::vec3& direction) const;

 private:
  struct Wave {
    glm::vec3 way{0};
    float phase = 0;
  };
  std::array<Wave, 6> waves_;
};

}  // namespace panicle::bunch
