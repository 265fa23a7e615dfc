// Soft random unevenness in a box: for the surface of a crown, and for wandering branches.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace panicle::particles {

// Value noise: random values at the points of a lattice about the origin, interpolated between them. Values depend on
// the point alone: overlapping boxes agree.
class ValueNoise {
 public:
  ValueNoise() = default;
  // `edge`: of the lattice. Places outside of the box have the value of the nearest cell.
  ValueNoise(const glm::vec3& low, const glm::vec3& high, float edge, std::uint64_t seed);

  // 0 … 1.
  float at(const glm::vec3& p) const;

 private:
  float edge_ = 1;
  glm::ivec3 first_{0}, count_{1};
  std::vector<float> values_{0};
};

}  // namespace panicle::particles
