// Which flowers set: as many as there are to be berries, spread so that each has room.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace panicle::bunch {

struct Bud {
  glm::vec3 place{0};   // where its berry would hang, millimetres
  float chance = 0;     // 0 … 1, its own; the same whatever else grows
  float misplaced = 0;  // how far outside the outline, in berry widths; 0 inside
  float strength = 1;   // 0 … 1: how far what bears it has grown
};

// Per bud the volume its berry will have over that of a berry of its own; 0 where it does not set. Buds are ranked by
// chance and by how crowded their place is, within `size`; the `berries` best set, the last few of them smaller the
// nearer they are to not setting (shot berries), so that a small change of places or number changes all by little.
std::vector<float> choose_set(std::span<const Bud> buds, float berries, float size);

}  // namespace panicle::bunch
