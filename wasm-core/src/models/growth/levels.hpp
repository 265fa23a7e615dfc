// A tree at four distances, each of them one mesh: what is seen of thousands of trees, none of which is near. Counts
// fall by a factor from each to the next; what is left out or merged is told in metres.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "models/growth/moment.hpp"
#include "plant/plant.hpp"

namespace panicle::growth {

inline constexpr std::size_t level_count = 4;

struct Levels {
  std::array<PlantMesh, level_count> meshes;  // from near to far, as model.hpp says
  // The thickness of the thickest shoot that each leaves out, or the size of its largest merged leaf, in metres.
  std::array<float, level_count> tolerance{};
};

// `leaves`: those on the ground are left out. `blade_area`: of a leaf of length 1, one side.
Levels levels_of(const Moment& moment, std::span<const Organ> leaves, float blade_area);

}  // namespace panicle::growth
