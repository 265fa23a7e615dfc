// How much of the sky reaches a place of a plant: by a lattice of cells and what is in them, so that it costs the same
// for a hundred lines as for a hundred thousand.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "environment/voxel_light.hpp"
#include "geometry/mesh.hpp"
#include "geometry/segment.hpp"

namespace panicle {

// Something without thickness, or round, that hides some sky.
struct Screen {
  glm::vec3 place{0};
  float area = 0;  // that it hides, taken over all directions
};

class Openness {
 public:
  // Of rods and screens. What lies between their ends has so many cells along its longest edge, lit from so many
  // directions.
  Openness(std::span<const Segment> segments, std::span<const Screen> screens, float cells = 32,
           std::uint32_t directions = 32);

  // 255 all of the sky, 0 none.
  std::uint8_t at(const glm::vec3& place) const;
  float edge() const { return light_.edge(); }  // of a cell
  // Of each vertex.
  std::vector<std::uint8_t> of(const Mesh& mesh) const;

 private:
  VoxelLight light_;
};

}  // namespace panicle
