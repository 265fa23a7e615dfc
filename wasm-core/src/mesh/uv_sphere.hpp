// A sphere mesh with texture coordinates, the default shape of S.
#pragma once

#include <cstdint>

#include "mesh/mesh.hpp"

namespace panicle {

// Radius 1 about the origin, closed; u goes round the axis (+Y is v = 1), `segments` (3 or more) times round and half
// as many from pole to pole.
Mesh make_uv_sphere(std::uint32_t segments);

}  // namespace panicle
