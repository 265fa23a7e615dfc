// Measures of a plant that a grammar has grown; docs/models/grammar/measures.md lists their units.
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
  float metres = 0.01f;          // length of one unit of the sketch
  WorkBudget* budget = nullptr;  // work budget that filling polygons is counted against
};

// Sets the measures of a plant after `dress`; with growth areas, also the columns `areas.volume` (float32, m³) and
// `areas.clothed` (float32, share) of each.
void measure(Plant& plant, const MeasureInput& input);

}  // namespace panicle::grammar
