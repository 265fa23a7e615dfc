// The ground of a stand: gentle relief, the same everywhere.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "mesh/mesh.hpp"
#include "models/stand/plan.hpp"

namespace panicle::stand {

class Relief {
 public:
  Relief(const Ground& ground, std::uint64_t seed);

  // Metres; 0 in the mean, and never further from it than half the relief.
  float at(float x, float z) const;
  // A grid over the whole ground; uv in metres.
  Mesh mesh() const;

 private:
  static constexpr std::uint32_t waves = 5;
  Ground ground_;
  glm::vec2 number_[waves];  // radians a metre
  float phase_[waves], weight_[waves];
};

}  // namespace panicle::stand
