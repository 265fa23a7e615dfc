// The open flower that unset berries share.
#pragma once

#include "geometry/mesh.hpp"

namespace panicle::bunch {

// Five stamens (filament and anther) and the short style around an ovary of unit radius at the origin, facing +Y; the
// ovary itself is the berry. u runs round, v is 0 … 0.5 on filaments, 0.5 … 1 on anthers.
Mesh make_flower();

}  // namespace panicle::bunch
