// A sketch as a plant in metres, and the meshes it is seen by.
#pragma once

#include <cstdint>

#include "models/grammar/sketch.hpp"
#include "plant/plant.hpp"

namespace panicle::grammar {

struct DressOptions {
  float metres = 0.01f;  // of one unit of the grammar
  std::uint32_t sides = 10;
  bool meshes = true;
  bool sky = false;     // of the meshes
  bool marked = true;   // by the modules that drew things
  bool coarse = false;  // what will do while a hand still moves: of a plant of many lines fewer rings and sides
  WorkBudget* budget = nullptr;  // that filling polygons is counted against
};

// Segments, organs, their columns, and the meshes that model.hpp lists; a note on polygons that show nothing.
void dress(Plant& plant, const Sketch& sketch, const DressOptions& options);

}  // namespace panicle::grammar
