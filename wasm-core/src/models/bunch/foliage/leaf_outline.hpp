// The outline of a grapevine leaf: five lobes about a petiole sinus, toothed all along.
#pragma once

#include <array>
#include <cstdint>

namespace panicle::bunch {

// Sectors between neighbouring main veins, and between the outermost and the sinus: six, from left to right. Places in
// the blade are a sector and a share τ of it, so that veins always lie where τ is 0 or 1.
inline constexpr std::uint32_t leaf_sectors = 6;
inline constexpr std::uint32_t leaf_teeth = 8;  // in a sector

class LeafOutline {
 public:
  explicit LeafOutline(std::uint64_t seed);

  // Degrees from the midrib, positive to the right.
  float angle(std::uint32_t sector, float share) const;
  // Distance of the margin without its teeth, in midribs.
  float radius(std::uint32_t sector, float share) const;
  // How far the margin with its teeth lies beyond that. Teeth stand at whole numbers of `tooth` from 0 to leaf_teeth,
  // one at the end of every vein, notches halfway between.
  float jut(std::uint32_t sector, float tooth) const;

 private:
  struct Side {
    float upper, lower;              // lengths of the veins beside the midrib
    float upper_sinus, lower_sinus;  // distances of the bays between lobes
    float sinus_angle;               // where the petiole sinus begins
    float auricle;                   // length of its edge
  };

  std::uint64_t seed_;
  std::array<Side, 2> sides_;
};

}  // namespace panicle::bunch
