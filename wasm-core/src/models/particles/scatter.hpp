// Where particles start: patterns of points in a region.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/particles/extent.hpp"
#include "spatial/region.hpp"

namespace panicle::particles {

enum class Pattern : std::uint32_t {
  uniform,   // each for itself: leaves holes
  jittered,  // one in each cell of a lattice, at most 0.4 cells from its middle
  blue,      // none nearer to another than is told: even, without a lattice's rows
};

// The spacing of `count` points that fill a region evenly: the root of its area or volume a point, where places count
// by their density.
float spacing_of(const Region& region, std::uint32_t count);

struct Scattered {
  std::vector<glm::vec3> points;
  float spacing = 0;  // `spacing_of` the region, grown
  Extent extent;      // of the region
};

// `count` points inside a region, or as many as a lattice fine enough for it may have. `growth`: the size of the region
// over what it will be: then there are as many fewer as it is smaller, and jittered ones are where they will be.
Scattered scatter_all(const Region& region, Pattern pattern, std::uint32_t count, std::uint64_t seed, float growth = 1);

// With a spacing that is told: about `count` points inside the region (of the uniform pattern exactly so many, unless
// the region is empty), as dense as it says. Cells lie about the origin, not about the region, and luck is a place's
// own: a region that changes a little keeps the points that it still holds, as long as their spacing stays.
std::vector<glm::vec3> scatter(const Region& region, Pattern pattern, std::uint32_t count, float spacing,
                               std::uint64_t seed);

}  // namespace panicle::particles
