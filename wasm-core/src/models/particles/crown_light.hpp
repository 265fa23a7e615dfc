// Light in a crown that shades itself and its neighbours (Rodkaew et al. 2003, section 4.2), and the density that
// follows it.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "light/voxel_light.hpp"
#include "models/particles/obstacles.hpp"
#include "spatial/region.hpp"

namespace panicle::particles {

struct LightHabit {
  glm::vec3 sun{0, 1, 0};  // unit, towards it
  float sky = 1;           // share of the light that comes from all of the sky
  float absorption = 0;    // over a length of 1 through the crown
};

// The sun and 24 directions of an overcast sky, which sum up to 1.
std::vector<LightDirection> light_directions(const LightHabit& habit);
// The direction of the sun: the azimuth as in the tables (0 in front, +z; 90 at the right, +x) and the height above the
// horizon, in degrees.
glm::vec3 towards_sun(float azimuth, float height);

// The objects about a crown that take its light.
struct LightObstacles {
  std::span<const Box> crowns;  // ellipsoids that fill these boxes: other trees, as dense as this one
  std::span<const Box> walls;   // opaque boxes
};

// The light in a box about `crown`, all of which holds foliage: the inner boundary is semi-transparent, too. The box
// includes the shading objects as far away as the crown is wide, in cells of `edge`, or wider ones as needed to limit
// their number.
VoxelLight light_in(const Region& crown, const LightObstacles& shades, const LightHabit& habit, float edge);

}  // namespace panicle::particles
