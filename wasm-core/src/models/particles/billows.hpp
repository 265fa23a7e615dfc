// Soft random unevenness in a box: what a crown's surface is made of, and how branches wander.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace panicle::particles {

// Random values at the places of a lattice about the origin, and between them what lies between. The values belong to
// the places: another box has the same.
class Billows {
 public:
  Billows() = default;
  // `edge`: of the lattice. What is asked of places outside of the box is that of the nearest cell.
  Billows(const glm::vec3& low, const glm::vec3& high, float edge, std::uint64_t seed);

  // 0 … 1.
  float at(const glm::vec3& p) const;

 private:
  float edge_ = 1;
  glm::ivec3 first_{0}, count_{1};
  std::vector<float> values_{0};
};

}  // namespace panicle::particles
