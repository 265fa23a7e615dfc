// Which of many balls touch: by a grid, in time linear in their number where they are of like size.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

namespace panicle::bunch {

struct Ball {
  glm::vec3 centre{0};
  float radius = 0;
};

// All pairs (a, b), a < b, of balls that touch or overlap, by a, then by b. Balls that are not finite touch nothing.
std::vector<std::pair<std::uint32_t, std::uint32_t>> touching_pairs(std::span<const Ball> balls);

}  // namespace panicle::bunch
