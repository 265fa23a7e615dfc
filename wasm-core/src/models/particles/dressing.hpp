// What is seen of a tree or a root: tubes along its trails, balls for particles on their way, and how open the sky is in it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "environment/voxel_light.hpp"
#include "models/particles/trails.hpp"
#include "models/particles/trail_plant.hpp"
#include "plant/plant.hpp"

namespace panicle::particles {

// Of each segment the axis that it belongs to: at a fork the heaviest goes on. `numbers`: what `add_trails` gave.
std::vector<std::int32_t> axes_of(std::span<const Trails> crowds, std::span<const std::vector<std::int32_t>> numbers,
                                  std::size_t segments);

// Appends an organ (tag `tag`, no mesh yet) for each particle that is on its way after so many steps. `trails`: all, as they
// are in the end.
void add_travellers(Plant& plant, const Trails& trails, std::uint32_t step, double all, const Girth& girth,
                    float least_radius, std::uint32_t tag);

// Appends the mesh `stems`: tubes along the axes, thin ones with fewer sides. Columns: `segment`, and `sky` where it is asked
// for.
void add_stems(Plant& plant, std::span<const std::int32_t> axes, std::string_view material, const VoxelLight* sky);

// How much of the whole sphere of directions is open in a plant whose leaves (organs of tag `leaf_tag`) have `leaf_area` at scale
// 1, as docs/sky.md has it but from cells: what a leaf sees is hidden by ever so many others.
VoxelLight openness(const Plant& plant, std::uint32_t leaf_tag, float leaf_area);
std::vector<std::uint8_t> sky_of_organs(const Plant& plant, const VoxelLight& sky);

}  // namespace panicle::particles
