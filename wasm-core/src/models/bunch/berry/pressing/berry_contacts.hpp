// The contacts of berries: one plane for every pair of near neighbours, the same for both.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/bunch/berry/berry_body.hpp"
#include "models/bunch/berry/berry_meridian.hpp"

namespace panicle::bunch {

// The transform from unit space: position = centre + axes · point.
struct BerryFrame {
  glm::vec3 centre{0};
  glm::mat3 axes{1};  // columns: half_width × across, half_length × direction, half_width × across
};

// `roll` turns the berry about its direction, in degrees.
BerryFrame frame_of(const BerryBody& body, float roll);

// A half-space that contains a berry, in its own unit space: slope · point ≤ 1. The plane is `from` its centre in world
// space; it dents the free form by `depth` times that; below 0 it does not touch it.
struct BerryPlane {
  glm::vec3 slope{0};
  float from = 0, depth = 0;
  std::uint32_t neighbour = 0;
  std::uint32_t twin = 0;  // the same plane among the neighbour's
};

// Berry i has the planes from first[i] to first[i + 1], ordered by the neighbour's index.
struct BerryContacts {
  std::vector<std::uint32_t> first;
  std::vector<BerryPlane> planes;

  // The planes that press on a berry.
  std::span<const BerryPlane> of(std::size_t berry) const {
    return std::span(planes).subspan(first[berry], first[berry + 1] - first[berry]);
  }

  // Moves a plane away from its berry, towards the neighbour; the neighbour's plane moves along.
  void move(std::size_t plane, float distance);
};

// Finds a plane for every pair whose free forms, `reach` times as large, could meet: at right angles to the direction
// in which they overlap least (or are furthest apart), between their furthest points in that direction. These are
// nearer to the plane's berry of the larger radius of curvature in such a way that two spheres meet the plane in one
// circle, to first order. Centres stay on their own side, however much the berries overlap; berries that share a centre
// share no plane.
BerryContacts find_contacts(std::span<const BerryFrame> frames, const BerryMeridian& meridian, float reach);

}  // namespace panicle::bunch
