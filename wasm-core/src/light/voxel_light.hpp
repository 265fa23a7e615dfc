// Light in a box of semi-transparent cells, which shade each other (Rodkaew et al. 2003, section 4.2).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "foundation/lane_vectors.hpp"

namespace panicle {

// A direction of light: the unit vector towards its source, and its share of all light.
struct LightDirection {
  glm::vec3 towards;
  float share;
};

// An overcast sky: `count` directions above the horizon, denser the higher they are (by their cosine), of almost equal
// shares.
std::vector<LightDirection> overcast(std::uint32_t count);
// `count` directions, uniform over the sphere, below the horizon too.
std::vector<LightDirection> all_round(std::uint32_t count);

class VoxelLight {
 public:
  // Cells of `edge`, `x` × `y` × `z` of them from the corner `low`. `matter`: the density in each, x fastest; over a
  // length of 1 a density of 1 attenuates light by exp(−1).
  VoxelLight(const glm::vec3& low, float edge, std::uint32_t x, std::uint32_t y, std::uint32_t z,
             std::span<const float> matter, std::span<const LightDirection> lamps);

  // The share of all light that reaches a place, 0 … 1: interpolated between the middles of cells, outside the box as
  // at its edge.
  float at(const glm::vec3& p) const;
  // The same for four places.
  Four at(const FourVectors& p) const;
  // The gradient of that share: 0 where it is constant, and across the box's edges.
  glm::vec3 ascent(const glm::vec3& p) const;
  float edge() const { return edge_; }  // of a cell
  const glm::vec3& low() const { return low_; }
  // The numbers of cells along x, y and z, and the share of all light in the middle of each, x fastest.
  std::array<std::uint32_t, 3> counts() const;
  std::span<const float> cells() const { return light_; }

 private:
  // The eight cells around a place, and its fraction from the first to the next along each axis.
  struct Corner {
    std::size_t lower[3], upper[3];  // offsets
    float share[3];
  };
  Corner corner_of(const glm::vec3& p) const;
  // The optical depth at a layer, and at the one before it.
  struct Planes {
    std::vector<float> before, here;
  };
  void shine(const LightDirection& lamp, std::span<const float> matter, Planes& planes);
  std::size_t index(std::int32_t x, std::int32_t y, std::int32_t z) const;

  glm::vec3 low_;
  float edge_;
  std::int32_t count_[3];
  std::vector<float> light_;
};

}  // namespace panicle
