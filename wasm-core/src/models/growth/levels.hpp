// A tree at four distances, each of them one mesh, for forests of thousands of trees far away. Counts fall by a factor
// from each to the next; `tolerance` states the size of omitted or merged parts in metres.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "models/growth/moment.hpp"
#include "plant/plant.hpp"

namespace panicle::growth {

inline constexpr std::size_t level_count = 4;

struct TreeLevels {
  std::vector<PlantMesh> meshes;  // from near to far, see model.hpp
  // The thickness of the thickest omitted shoot, or the size of the largest merged leaf of each level, in metres.
  std::vector<float> tolerance;
};

// The nearest `count` levels; a level does not depend on the others. Leaves on the ground are omitted. Areas: one side
// of a leaf and of a blossom of scale 1; 0: no such organs.
TreeLevels levels_of(const Moment& moment, std::span<const Organ> organs, float leaf_area, float blossom_area,
                     std::size_t count = level_count);

}  // namespace panicle::growth
