// Posts and wires along the rows of layers with a trellis; they follow the ground as the tied plants do.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"
#include "models/stand/ground.hpp"
#include "models/stand/places.hpp"
#include "models/stand/plan.hpp"

namespace panicle::stand {

struct Trellises {
  std::uint32_t posts = 0;
  Mesh wood, metal;  // of all posts, of all wires
};

Trellises trellises_of(const Plan& plan, const Relief& relief, const std::vector<Placement>& plants);

}  // namespace panicle::stand
