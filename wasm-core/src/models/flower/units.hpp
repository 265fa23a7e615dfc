// Converts coordinates of a flower's text to those of plants: millimetres to metres, +Z up to +Y up.
#pragma once

#include <glm/vec3.hpp>

namespace panicle::flower {

inline constexpr float metres = 0.001f;  // a millimetre in metres

// Converts a direction; positions must also be multiplied by `metres`.
inline glm::vec3 y_up(const glm::vec3& v) { return {v.x, v.z, -v.y}; }

}  // namespace panicle::flower
