// A straight piece of a plant's skeleton, from one node to the next. Its meaning and the unit of lengths are the
// model's own.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace panicle {

struct Segment {
  std::int32_t parent = -1;  // index of an earlier segment; −1 at a root
  std::uint32_t tag = 0;     // which of its model's kinds of segment it is
  glm::vec3 start{0}, end{0};
  float radius = 0;      // at the start
  float radius_end = 0;  // at the end
};

// Scales lengths and thicknesses, from one unit to another.
inline void scale(Segment& segment, float factor) {
  segment.start *= factor;
  segment.end *= factor;
  segment.radius *= factor;
  segment.radius_end *= factor;
}

}  // namespace panicle
