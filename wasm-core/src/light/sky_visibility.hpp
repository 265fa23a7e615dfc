// How much of the sky reaches a place of a plant, by a grid of cells with densities: the cost is the same for a hundred
// lines as for a hundred thousand.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "light/voxel_light.hpp"
#include "mesh/mesh.hpp"
#include "stems/segment.hpp"

namespace panicle {

// A disc or a ball that hides some sky.
struct Occluder {
  glm::vec3 place{0};
  float area = 0;  // that it hides, taken over all directions
};

class SkyVisibility {
 public:
  // Builds the grid from segments and occluders. The box of their ends has so many cells along its longest edge, lit
  // from so many directions.
  SkyVisibility(std::span<const Segment> segments, std::span<const Occluder> screens, float cells = 32,
                std::uint32_t directions = 32);

  // The sky at a place: 255 all, 0 none.
  std::uint8_t at(const glm::vec3& place) const;
  // The sky at many places, `place_of(i)` for i from 0 to `count`: equal to `at`, four at a time.
  template <class PlaceOf>
  std::vector<std::uint8_t> of(std::size_t count, PlaceOf place_of) const {
    std::vector<std::uint8_t> bytes(count);
    for (std::size_t i = 0; i < count; i += 4) {
      const std::size_t here = std::min<std::size_t>(count - i, 4);
      FourVectors places{};
      for (std::size_t lane = 0; lane < here; ++lane) {
        const glm::vec3& place = place_of(i + lane);
        places.x[lane] = place.x;
        places.y[lane] = place.y;
        places.z[lane] = place.z;
      }
      const Four open = light_.at(places);
      for (std::size_t lane = 0; lane < here; ++lane) bytes[i + lane] = byte_of(open[lane]);
    }
    return bytes;
  }
  float edge() const { return light_.edge(); }  // of a cell
  // The sky at each vertex.
  std::vector<std::uint8_t> of(const Mesh& mesh) const;

 private:
  // A share, 0 … 1, as a byte.
  static std::uint8_t byte_of(float open) {
    return static_cast<std::uint8_t>(std::clamp(open, 0.0f, 1.0f) * 255 + 0.5f);
  }

  VoxelLight light_;
};

}  // namespace panicle
