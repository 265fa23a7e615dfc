// Converts a sketch into a plant in metres, with its meshes.
#pragma once

#include <cstdint>

#include "models/grammar/sketch.hpp"
#include "plant/plant.hpp"

namespace panicle::grammar {

struct DressOptions {
  float metres = 0.01f;  // length of one unit of the grammar
  std::uint32_t sides = 10;
  bool meshes = true;
  bool sky = false;              // whether meshes have sky visibility
  bool marked = true;            // whether segments and organs name the modules that drew them
  bool coarse = false;           // preview quality while the user drags: fewer rings and sides for plants of many lines
  WorkBudget* budget = nullptr;  // work budget that filling polygons is counted against
};

// Adds segments, organs, their columns, and the meshes that model.hpp lists; a note counts polygons without area.
void dress(Plant& plant, const Sketch& sketch, const DressOptions& options);

}  // namespace panicle::grammar
