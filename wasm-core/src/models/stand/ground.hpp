// The ground of a stand: gentle relief that does not depend on the plants.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "mesh/mesh.hpp"
#include "models/stand/plan.hpp"

namespace panicle::stand {

class Relief {
 public:
  Relief(const Ground& ground, std::uint64_t seed);

  // Height in metres; 0 in the mean, and at most half the relief away from it.
  float at(float x, float z) const;
  // A grid over the whole ground; texture coordinates in metres.
  Mesh mesh() const;

 private:
  static constexpr std::uint32_t waves = 5;
  Ground ground_;
  glm::vec2 number_[waves];  // wave vectors, radians a metre
  float phase_[waves], weight_[waves];
};

}  // namespace panicle::stand
