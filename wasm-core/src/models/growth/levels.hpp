// A tree at four distances, each of them one mesh: what is seen of thousands of trees, none of which is near. Counts
// fall by a factor from each to the next; what is left out or merged is told in metres.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "models/growth/moment.hpp"
#include "plant/plant.hpp"

namespace panicle::growth {

inline constexpr std::size_t level_count = 4;

struct TreeLevels {
  std::vector<PlantMesh> meshes;  // from near to far, as model.hpp says
  // The thickness of the thickest shoot that each leaves out, or the size of its largest merged leaf, in metres.
  std::vector<float> tolerance;
};

// The nearest `count` of them: each is what it is whatever others are asked for. What lies on the ground is left out.
// Areas: of a leaf and of a blossom of scale 1, one side; 0: there are none.
TreeLevels levels_of(const Moment& moment, std::span<const Organ> organs, float leaf_area, float blossom_area,
                 std::size_t count = level_count);

}  // namespace panicle::growth
