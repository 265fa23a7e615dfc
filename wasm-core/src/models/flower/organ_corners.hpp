// Positions of faces' corners in their organs, for their colours: along the organ, and beside its middle. Organs that
// touch have separate corners there.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "mesh/subdivision.hpp"
#include "models/flower/derivation.hpp"

namespace panicle::flower {

// Merges the corners of an organ at a vertex, once for a map; `places` then depends on sizes too.
class OrganCorners {
 public:
  // `volume`: of each of the surface's faces.
  OrganCorners(const Derived& derived, const ClosedSurface& surface, const std::vector<std::uint32_t>& volume);

  // Positions by half-edge, both 0 … 1: along, the mean over the organ's faces at the corner; beside, the least of
  // them, so that a lobe extends from the end of its inner neighbour to the next.
  std::vector<glm::vec2> places(const Derived& derived) const;
  std::uint64_t bytes() const;  // memory that it holds, roughly

 private:
  std::vector<std::uint32_t> volume_;  // by half-edge, of its face
  std::vector<std::uint32_t> corner_;  // by half-edge, number of its corner
  std::uint32_t corners_ = 0;
};

// The positions on the refined surface: interpolated over each face.
std::vector<glm::vec2> refined_places(const ClosedSurface& surface, const std::vector<glm::vec2>& places);

}  // namespace panicle::flower
