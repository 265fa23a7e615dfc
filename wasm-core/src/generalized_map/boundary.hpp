// The boundary of a map: its free faces. They are a closed surface, for at each edge exactly two of them meet.
#pragma once

#include <cstdint>
#include <vector>

#include "generalized_map/embedding.hpp"
#include "generalized_map/map.hpp"
#include "mesh/subdivision.hpp"

namespace panicle::generalized_map {

struct Boundary {
  ClosedSurface surface;              // its vertices are the embedding's
  std::vector<std::uint32_t> volume;  // of its faces, whose they are
  std::vector<Face> face;             // and which
};

// Returns the boundary of a map whose `embedding` has been built and placed. Sheets that touch in a vertex alone share
// it.
Boundary boundary_of(const Map& map, const Embedding& embedding);

}  // namespace panicle::generalized_map
