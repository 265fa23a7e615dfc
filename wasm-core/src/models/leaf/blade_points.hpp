// The vertices of the blade's mesh: on the margin, on veins, and on a lattice between.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "models/leaf/shape/blade.hpp"

namespace panicle::particles::leaf {

struct BladePoints {
  std::vector<glm::vec2> points;  // the ring first, counter-clockwise
  std::size_t ring = 0;
  std::vector<float> rise;  // of each point: the vein's radius on its axis, 0 elsewhere; leaf lengths
};

BladePoints place_points(const Margin& margin, const Outline& outline, std::span<const VeinPiece> veins, float detail);

}  // namespace panicle::particles::leaf
