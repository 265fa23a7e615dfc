// How much of the sky every part of a bunch sees: berries, stems, leaves, cane.
#pragma once

#include "models/bunch/grown.hpp"

namespace panicle::bunch {

// Fills in `grown.sky`, of the meshes that are there. A berry hides from itself nothing, its pedicel nothing from it; a
// long one stands as a row of balls. Stems, but for the many
// thin pedicels, and leaves hide a little of what is near. Leaves are lit from both sides: of
// the two the better is told. Open flowers hide what the berries hide that they will be, and have no bytes of their
// own.
void add_sky(GrownBunch& grown);

}  // namespace panicle::bunch
