// Light and room around a plant, computed by its caller: heights of the horizon, and free room. Metres and degrees, +Y
// up, azimuths from +X to +Z.
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

  // An open sky and unlimited room.
  Surroundings() = default;
  // From heights of the horizon at the azimuths 0°, 45° …, then as many metres of room from the origin. Errors:
  // bad_request, where these are not sixteen finite numbers.
  static Result<Surroundings> of(std::span<const float> numbers);

  bool is_open() const { return is_open_; }
  // Whether a place is within the room, which is the octagon through the ends of its eight directions.
  bool contains(const glm::vec3& p) const;
  // Whether all places within a radius are certainly within the room; false does not exclude it.
  bool contains_around(const glm::vec3& p, float radius) const;
  // The directions with a share of 0 for those behind the horizon.
  std::vector<LightDirection> dimmed(std::vector<LightDirection> directions) const;

 private:
  bool is_open_ = true;
  std::array<float, sides> horizon_{}, room_{};
  float least_ = 0;  // distance to the nearest edge of the room, metres
};

}  // namespace panicle::growth
