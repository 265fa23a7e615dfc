// Surfaces that tests share.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "foundation/random.hpp"
#include "spatial/closed_surface.hpp"

namespace panicle {

// An L of two boxes that share a face, as one surface with the shared face left out: concave.
inline Surface corner() {
  const std::vector<glm::vec2> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  Surface made;
  for (const float z : {0.0f, 1.0f})
    for (const glm::vec2& p : outline) made.points.emplace_back(p.x, p.y, z);
  for (std::uint32_t k = 0; k < 6; ++k) {
    const std::uint32_t a = k, b = (k + 1) % 6;
    made.triangles.insert(made.triangles.end(), {a, b, b + 6, a, b + 6, a + 6});
  }
  for (const auto& [a, b, c] : {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    made.triangles.insert(made.triangles.end(), {a, c, b});
    made.triangles.insert(made.triangles.end(), {a + 6, b + 6, c + 6});
  }
  return made;
}

// Closed tetrahedra of random corners in a cube of edge 1, so large that most span it: meshes in which very many
// triangles are around every place.
inline Surface spanning_tetrahedra(std::uint32_t count) {
  Surface made;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint64_t at = 4 * i + k;
      made.points.emplace_back(random_unit(8, 1, at), random_unit(8, 2, at), random_unit(8, 3, at));
    }
    for (const std::uint32_t corner : {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0}) made.triangles.push_back(4 * i + corner);
  }
  return made;
}

}  // namespace panicle
