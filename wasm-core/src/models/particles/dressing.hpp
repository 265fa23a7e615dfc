// What is seen of a tree or a root: tubes along its trails, and how open the sky is in it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "models/particles/grown.hpp"
#include "models/particles/trail_plant.hpp"
#include "models/particles/trails.hpp"
#include "plant/plant.hpp"

namespace panicle::particles {

// Appends the mesh `stems` of a material: tubes along the axes, at each fork on into the heaviest, thin ones with fewer
// sides. Columns: `segment`, and with `sky` a byte a vertex, `sky`, and one an organ, the plant's `organs.sky`:
// docs/sky.md, but from cells, for what a leaf sees is hidden by ever so many others. Organs of tag `leaf` have
// `leaf_area` at scale 1.
void dress(Plant& plant, const Grown& grown, std::string_view material, std::uint32_t leaf, float leaf_area, bool sky);

}  // namespace panicle::particles
