// What is seen of a flower: the boundary of its map, rounded, a mesh a material.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generalized_map/embedding.hpp"
#include "models/flower/derivation.hpp"
#include "plant/plant.hpp"

namespace panicle::flower {

// What volumes with a number as m are made of: as the text says, or by a list of ours (docs/models/flower/language.md).
Material material_of(const Program& program, std::uint32_t number);

// Meshes in metres, +Y up, by their materials' numbers. `rounds`: how often it is subdivided, 0 to 3. Columns of each:
//   volume   uint32 a triangle: the volume that it is of
//   face     uint16 as uint32 a triangle: which of its faces, 0 O, 1 E, from 2 on C1 …
//   sky      uint8 a vertex, where it is asked for
//   uvs      u how far along its organ, v how far beside the middle, both 0 … 1
// Error: limit, where there would be more triangles than there may be.
Diagnostic add_skin(Plant& plant, const Program& program, const Derived& derived,
                    const generalized_map::Embedding& embedding, std::uint32_t rounds, bool sky);

}  // namespace panicle::flower
