// From where a flower's text measures to where plants stand: millimetres to metres, +Z up to +Y up.
#pragma once

#include <glm/vec3.hpp>

namespace panicle::flower {

inline constexpr float metres = 0.001f;  // of a millimetre

// A direction; a place still wants its `metres`.
inline glm::vec3 upright(const glm::vec3& v) { return {v.x, v.z, -v.y}; }

}  // namespace panicle::flower
