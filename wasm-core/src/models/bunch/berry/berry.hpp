// The one berry that all berries of a bunch share.
#pragma once

#include "mesh/mesh.hpp"

namespace panicle::bunch {

struct BerryOptions {
  std::uint32_t segments = 24;  // meridians, 6 … 128; parallels follow: three for every four meridians
};

// From this v on lies the scar, the brown point that the style leaves.
inline constexpr float berry_scar_v = 0.965f;

// A closed surface within the unit sphere about the origin, touching it nearly everywhere, its tip scar (the dried
// style in a small dimple) towards +Y and the pedicel's seat, a little flattened, towards −Y. u runs round, v from seat
// (0) to scar (1) in proportion to the angle; the seam and the poles are doubled for u. (segments + 1) × parallels + 2
// × segments vertices: 498 by default.
Mesh make_berry(const BerryOptions& options);

}  // namespace panicle::bunch
