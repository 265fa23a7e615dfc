// What there is to measure on what a text has grown: docs/models/grammar/measures.md has the units.
#pragma once

#include "lsystem/lsystem.hpp"
#include "models/grammar/areas.hpp"
#include "models/grammar/sketch.hpp"
#include "plant/plant.hpp"

namespace panicle::grammar {

struct MeasureInput {
  const Sketch& sketch;
  const lsystem::String& string;
  const Areas& areas;
  float metres = 0.01f;          // of one unit of the sketch
  WorkBudget* budget = nullptr;  // that filling polygons is counted against
};

// Puts them into a plant that has been dressed; and where there are growth areas, of each the columns `areas.volume`
// (float32, m³) and `areas.clothed` (float32, share).
void measure(Plant& plant, const MeasureInput& input);

}  // namespace panicle::grammar
