// Checks whether all of a plant's geometry can be drawn. Every plant of every model is checked before it leaves the
// core (exports/panicle.cpp).
#pragma once

#include "foundation/result.hpp"
#include "plant/plant.hpp"

namespace panicle {

// The first number that is not finite, of segments, organs and meshes and of the columns that hold places ("spheres",
// "places", "positions", "normals"): an error of reason evaluation, which has the number of the segment or organ, or
// names the mesh and its part, or the column. Reason::none where there is none.
Diagnostic check_geometry(const Plant& plant);

}  // namespace panicle
