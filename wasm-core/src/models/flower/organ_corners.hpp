// Where in its organ each corner of a face is, which is where its colours come from: how far along, and how far beside
// the middle. Organs that touch have each their own there.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "mesh/subdivision.hpp"
#include "models/flower/derivation.hpp"

namespace panicle::flower {

// Which corners are one, those of an organ at a vertex, is laid once a map; where they are follows from sizes too.
class OrganCorners {
 public:
  // `volume`: of the surface's faces, whose they are.
  OrganCorners(const Derived& derived, const ClosedSurface& surface, const std::vector<std::uint32_t>& volume);

  // By half-edge, both 0 … 1: along, what the organ's faces about it have; beside, where its inner neighbour ends, so
  // that a lobe reaches from there to the next.
  std::vector<glm::vec2> places(const Derived& derived) const;
  std::uint64_t bytes() const;  // that it holds, about

 private:
  std::vector<std::uint32_t> volume_;  // by half-edge, whose face it is
  std::vector<std::uint32_t> corner_;  // and which corner
  std::uint32_t corners_ = 0;
};

// The same of the surface refined: even over each face.
std::vector<glm::vec2> refined_places(const ClosedSurface& surface, const std::vector<glm::vec2>& places);

}  // namespace panicle::flower
