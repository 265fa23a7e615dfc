// Polygons as sheets, and as plates where they have a thickness: one mesh, a run each.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/grammar/sketch.hpp"
#include "plant/plant.hpp"

namespace panicle::grammar {

// The mesh `blades`, in the unit of the corners times `scale`, with the columns `colour` (uint8 a run) and `organ`
// (uint32 a run: which of all that is borne). A polygon without a triangle has no run; `empty` counts them.
PlantMesh blades_of(const Polygons& polygons, float scale, std::uint32_t& empty, WorkBudget* budget = nullptr);

}  // namespace panicle::grammar
