// A grid of cells with the density of many small objects that shade each other, for VoxelLight.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "light/voxel_light.hpp"

namespace panicle {

class DensityGrid {
 public:
  // A grid of empty cells of `edge` from the corner `low` to beyond `high`; a single cell along an axis where their
  // number would not be finite, or at least 4,096.
  DensityGrid(const glm::vec3& low, const glm::vec3& high, float edge);

  // Adds an object at a place (beside the lattice: in the nearest cell) that hides so much area, as a mean over all
  // directions: half of a sheet's area, a quarter of a rod's surface.
  void put(const glm::vec3& place, float area);

  // The number of cells.
  std::size_t cells() const { return matter_.size(); }

  VoxelLight light(std::span<const LightDirection> lamps) const;

 private:
  glm::vec3 low_;
  float edge_, per_volume_;  // of a cell, and 1 over its volume
  glm::ivec3 count_;
  std::vector<float> matter_;
};

}  // namespace panicle
