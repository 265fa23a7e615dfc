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

// Per bud the volume its berry will have over that of a berry of its own; 0 where it does not set. A bud sets where its
// chance is below `fill` over what all buds within reach of it would fill if they set, so that berries of width `size`
// fill that share of the space everywhere alike. What a bud does hangs on its neighbours alone: growing one end of a
// bunch changes nothing at the other. Berries that only just set stay small (shot berries), so nothing jumps.
std::vector<float> choose_set(std::span<const Bud> buds, float fill, float size);

// The same with as many berries as are wanted, wherever that puts `fill`.
std::vector<float> choose_count(std::span<const Bud> buds, float berries, float size);

}  // namespace panicle::bunch
