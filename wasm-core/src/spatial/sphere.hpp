// A sphere.
#pragma once

#include <glm/vec3.hpp>

namespace panicle {

struct Sphere {
  glm::vec3 centre{0};
  float radius = 0;
};

}  // namespace panicle
