// The visible surface of a tree or a root: tubes along its trails, and how open the sky is in it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "models/particles/grown.hpp"
#include "models/particles/trail_plant.hpp"
#include "models/particles/trails.hpp"
#include "plant/plant.hpp"
#include "stems/root_flare.hpp"

namespace panicle::particles {

struct DressHabit {
  std::string_view material;
  std::uint32_t leaf = 0;  // tag of organs that are leaves
  float leaf_area = 0;     // of one at scale 1
  bool sky = false;
  RootFlareOptions foot;
};

// Appends the mesh `stems` of a material: tubes along the axes, at each fork on into the heaviest, thin ones with fewer
// sides, with the root flare of `habit`. Columns: `segment`, and with `sky` a byte a vertex, `sky`, and one an organ,
// the plant's `organs.sky`: docs/sky.md, but from cells, because a leaf's sky is hidden by very many others.
void dress(Plant& plant, const GrownWood& grown, const DressHabit& habit);

}  // namespace panicle::particles
