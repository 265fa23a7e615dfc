// Units of length: the grammars count in units of the paper, profiles in pixels of its 600 × 600 view, growth in
// millimetres, and results are in metres.
#pragma once

namespace panicle::bunch {

inline constexpr float metres_per_millimetre = 0.001f;
inline constexpr float units_per_pixel = 50.0f / 29.0f;  // one rachis segment is 29 pixels and l_i 50 units

}  // namespace panicle::bunch
