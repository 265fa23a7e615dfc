// The one berry that all berries of a bunch share.
#pragma once

#include "geometry/mesh.hpp"

namespace panicle {

struct BerryOptions {
  std::uint32_t segments = 24;  // meridians, 6 … 128; parallels follow
};

// A closed surface of unit radius about the origin, its tip scar (the dried style, a small dimple) towards +Y and
// the pedicel's seat towards −Y. u runs round, v from seat (0) to scar (1).
Mesh make_berry(const BerryOptions& options);

}  // namespace panicle
