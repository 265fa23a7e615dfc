// The share of the sky that every part of a bunch sees: berries, stems, leaves, cane.
#pragma once

#include "models/bunch/grown.hpp"

namespace panicle::bunch {

// Fills in `grown.sky` for the meshes of `grown`. A berry does not occlude itself or its pedicel, nor its pedicel the
// berry; a long berry counts as a row of balls. Stems, except the many thin pedicels, and leaves occlude a little of
// the sky of their surroundings. Leaves are lit from both sides, and the brighter side counts. Open flowers occlude as
// much as the berries that they become, and have no bytes of their own.
void add_sky(GrownBunch& grown);

}  // namespace panicle::bunch
