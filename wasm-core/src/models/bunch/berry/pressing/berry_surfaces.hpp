// The berries' surfaces: flattened where they meet, bulging elsewhere so that each keeps its volume.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/bunch/berry/berry.hpp"
#include "models/bunch/berry/berry_body.hpp"

namespace panicle::bunch {

// All berries of a bunch. Every berry has the vertices of one pattern, in its order, so that texture coordinates and
// triangles are the pattern's for each of them.
struct BerrySurfaces {
  std::vector<float> uvs;              // 2 × pattern vertices: u round, v from the pedicel's seat (0) to the scar (1)
  std::vector<std::uint32_t> indices;  // 3 × pattern triangles
  std::vector<float> positions;        // 3 × pattern vertices × berries, in the bodies' unit
  std::vector<float> normals;          // likewise
  std::vector<std::uint8_t> pressed;   // pattern vertices × berries: 0 free … 255 in contact, where bloom is rubbed off
};

// Each surface is closed, stays on its own side of the plane between it and any neighbour (so two never pass through
// each other) and holds the volume of its free form within 3 % where its neighbours leave that room.
BerrySurfaces press_berries(std::span<const BerryBody> bodies, const BerryForm& form, const BerryOptions& options);

}  // namespace panicle::bunch
