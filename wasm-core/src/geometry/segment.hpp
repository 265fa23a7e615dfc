// A piece of a stem: what one drawn module is, whatever the plant.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace panicle {

struct Segment {
  std::int32_t parent = -1;  // index of an earlier segment; −1 at a root
  std::uint32_t tag = 0;     // what it is, by the names that come with it
  glm::vec3 start{0};
  glm::vec3 end{0};
  float radius = 0;      // at the start
  float radius_end = 0;  // at the end
};

}  // namespace panicle
