// Twigs as pointed tubes of three sides: enough detail for thousands of them.
#pragma once

#include <cstdint>
#include <span>

#include "stems/tubes.hpp"

namespace panicle {

// Appends the tubes of all segments that begin thinner than `fine`, in the segments' unit. `axes`: of each segment the
// axis that it belongs to; those of one axis are one tube, which begins within its parent and is open there. Parts are
// left as they are. `bark`: the scale of texture coordinates.
void add_twigs(StemMesh& stem, std::span<const Segment> segments, std::span<const std::int32_t> axes, float fine,
               const BarkScale& bark);

}  // namespace panicle
