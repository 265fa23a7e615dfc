// The flowers that set: as many as the berries to grow, spread so that each has room.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace panicle::bunch {

struct Bud {
  glm::vec3 place{0};   // where its berry would hang, millimetres; in the frame of its own bunch
  float chance = 0;     // random, 0 … 1; independent of the rest of the bunch
  float misplaced = 0;  // how far outside the outline, in berry widths; 0 inside
  float strength = 1;   // 0 … 1: how far its stem has grown
  std::uint32_t bunch = 0;
};

// The rank of each bud, the lowest setting first: its chance times the share of space that all its bunch's buds within
// reach of it would fill if they set as berries of width `size`. A rank depends on a bud's neighbours alone: growing
// one end of a bunch changes nothing at the other.
std::vector<float> ranks_of(std::span<const Bud> buds, float size);

// The volume of each bud's berry over that of a full one; 0 where it does not set. Buds of ranks below `fill` set, so
// that berries fill that share of the space evenly. Berries that only just set stay small (shot berries), so that
// nothing jumps.
std::vector<float> choose_set(std::vector<float> ranks, float fill);

// The same for a given number of berries, with the `fill` that gives it.
std::vector<float> choose_count(std::vector<float> ranks, float berries);

// The buds in the order of their ranks.
std::vector<std::uint32_t> setting_order(std::span<const float> ranks);

}  // namespace panicle::bunch
