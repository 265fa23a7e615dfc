// What stands about a plant, worked out beforehand by whoever places it: how much of the sky is hidden, and how much
// room there is. Metres and degrees, +Y up, azimuths from +X to +Z.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "foundation/result.hpp"
#include "light/voxel_light.hpp"

namespace panicle::growth {

class Surroundings {
 public:
  static constexpr std::size_t sides = 8;

  // Nothing about it: all of the sky, all of the room.
  Surroundings() = default;
  // Heights of the horizon at the azimuths 0°, 45° …, then as many metres of room from the origin. Errors: bad_request,
  // where these are not sixteen finite numbers.
  static Result<Surroundings> of(std::span<const float> numbers);

  bool alone() const { return alone_; }
  // Whether a place is within the room; between two of its directions it ends at the line between its ends there.
  bool holds(const glm::vec3& p) const;
  // Whether all places so near to one surely are.
  bool holds_about(const glm::vec3& p, float radius) const;
  // Those lamps, the ones behind the horizon dark.
  std::vector<LightDirection> dimmed(std::vector<LightDirection> directions) const;

 private:
  bool alone_ = true;
  std::array<float, sides> horizon_{}, room_{};
  float least_ = 0;  // metres of room in whatever direction
};

}  // namespace panicle::growth
