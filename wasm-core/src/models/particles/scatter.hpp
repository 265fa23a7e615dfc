// Patterns of points in a region, where particles start.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/particles/extent.hpp"
#include "spatial/region.hpp"

namespace panicle::particles {

enum class Pattern : std::uint32_t {
  uniform,   // independent points: leaves holes
  jittered,  // one in each cell of a lattice, at most 0.4 cells from its middle
  blue,      // none nearer to another than the spacing: even, without a lattice's rows
};

// The spacing of `count` points that fill a region evenly: the root of its area or volume a point, weighted by density.
float spacing_of(const Region& region, std::uint32_t count);

struct Scattered {
  std::vector<glm::vec3> points;
  float spacing = 0;  // `spacing_of` the full-grown region
  Extent extent;      // of the region
};

// `count` points inside a region, or as many as a lattice fine enough for it may have. `growth`: the size of the region
// over the full-grown one: a smaller region has fewer points at the same spacing, and jittered ones are at their final
// places.
Scattered scatter_all(const Region& region, Pattern pattern, std::uint32_t count, std::uint64_t seed, float growth = 1);

// Points with a given spacing: about `count` points inside the region (of the uniform pattern exactly so many, unless
// the region is empty), at the density of the spacing. Cells lie about the origin, not about the region, and random
// values depend on the place alone: a region that changes a little keeps the points that it still contains, as long as
// their spacing stays.
std::vector<glm::vec3> scatter(const Region& region, Pattern pattern, std::uint32_t count, float spacing,
                               std::uint64_t seed);

}  // namespace panicle::particles
