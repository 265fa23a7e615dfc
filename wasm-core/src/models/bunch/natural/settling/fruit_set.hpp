// Which flowers set: as many as there are to be berries, spread so that each has room.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace panicle::bunch {

struct Bud {
  glm::vec3 place{0};   // where its berry would hang, millimetres; of its own bunch's
  float chance = 0;     // 0 … 1, its own; the same whatever else grows
  float misplaced = 0;  // how far outside the outline, in berry widths; 0 inside
  float strength = 1;   // 0 … 1: how far what bears it has grown
  std::uint32_t bunch = 0;
};

// Per bud how soon it sets, the lowest first: its chance times the share of space that all its bunch's buds within
// reach of it would fill if they set as berries of width `size`. What a bud does hangs on its neighbours alone: growing
// one end of a bunch changes nothing at the other.
std::vector<float> ranks_of(std::span<const Bud> buds, float size);

// Per bud the volume its berry will have over that of a berry of its own; 0 where it does not set. Those of ranks below
// `fill` set, so that berries fill that share of the space everywhere alike. Berries that only just set stay small
// (shot berries), so nothing jumps.
std::vector<float> choose_set(std::vector<float> ranks, float fill);

// The same with as many berries as are wanted, wherever that puts `fill`.
std::vector<float> choose_count(std::vector<float> ranks, float berries);

// Buds by rank.
std::vector<std::uint32_t> setting_order(std::span<const float> ranks);

}  // namespace panicle::bunch
