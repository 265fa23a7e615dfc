// Which flowers set: as many as there are to be berries, spread so that each has room.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace panicle::bunch {

struct Bud {
  glm::vec3 place{0};   // where its berry would hang, millimetres; of its own bunch's
  float chance = 0;     // random, 0 … 1; independent of the rest of the bunch
  float misplaced = 0;  // how far outside the outline, in berry widths; 0 inside
  float strength = 1;   // 0 … 1: how far its stem has grown
  std::uint32_t bunch = 0;
};

// The rank of each bud, the lowest setting first: its chance times the share of space that all its bunch's buds within
// reach of it would fill if they set as berries of width `size`. A rank depends on a bud's neighbours alone: growing
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
