// A leaf's meshes: blade, petiole and the particles on their way.
#pragma once

#include <span>
#include <vector>

#include "models/leaf/request.hpp"
#include "models/leaf/shape/bending.hpp"
#include "models/leaf/shape/veins.hpp"
#include "plant/plant.hpp"

namespace panicle::particles::leaf {

// Adds the meshes `upper`, `lower` (blade.hpp), `petiole` (material `stem`; unless its length is 0) and, where there
// are organs, `particle` (material `skin`), the mesh of all organs; and the column `sky` of the first three, if
// requested. `flat`: the trails as they are at that age, in the chart.
void dress(Plant& plant, const LeafRequest& leaf_request, const Veins& veins, std::span<const Trails> flat,
           const Bending& bending, const Girth& girth);

}  // namespace panicle::particles::leaf
