// Checks whether a map is valid: the invariants that every operation must preserve.
#pragma once

#include <cstdint>

#include "generalized_map/map.hpp"

namespace panicle::generalized_map {

enum class Fault : std::uint8_t {
  nothing,
  dangling,    // an α leads to no dart
  involution,  // α0, α1, α2 or α3 is none
  fixed,       // α0, α1 or α2 leaves a dart where it is, or α0 and α2 lead to one and the same
  product,     // α0α2, α0α3 or α1α3 is no involution
  foreign,     // a dart's volume is none, or α0, α1, α2 lead out of the volume, or α0, α1 out of the face
  folded,      // α3 joins a volume to itself
  cells,       // a volume's numbers of vertices, edges, faces or darts do not match its record
  corner,      // a corner's dart is not where it should be
  descent,     // a parent or a child that stands on its face is none
};

struct Finding {
  Fault fault = Fault::nothing;
  std::uint32_t at = none;  // the dart, or for the last three the volume
};

// Returns the first fault, in the order of the list. Time and memory are linear in the darts.
Finding check(const Map& map);

const char* words(Fault fault);

}  // namespace panicle::generalized_map
