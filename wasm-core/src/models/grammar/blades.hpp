// Polygons as sheets, or as plates where they have a thickness: one mesh with a run for each polygon.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/grammar/sketch.hpp"
#include "plant/plant.hpp"

namespace panicle::grammar {

// Builds the mesh `blades`, in the unit of the corners times `scale`, with the columns `colour` (uint8 a run) and
// `organ` (uint32 a run: index of the polygon's organ). A polygon without a triangle has no run; `empty` counts them.
PlantMesh blades_of(const Polygons& polygons, float scale, std::uint32_t& empty, WorkBudget* budget = nullptr);

}  // namespace panicle::grammar
