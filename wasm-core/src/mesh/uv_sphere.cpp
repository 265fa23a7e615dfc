#include "mesh/uv_sphere.hpp"

#include <algorithm>

#include "foundation/mathematics.hpp"

namespace panicle {

// A sphere of radius 1 with `segments` segments around and half as many rows.
Mesh make_uv_sphere(std::uint32_t segments) {
  const std::uint32_t round = std::max(segments, 3u), rows = std::max(round / 2, 2u);
  Mesh ball;
  for (std::uint32_t row = 0; row <= rows; ++row) {
    const float v = static_cast<float>(row) / static_cast<float>(rows);
    const SinCos tilt = sincos_degrees(180 * v - 90);
    for (std::uint32_t column = 0; column <= round; ++column) {
      const float u = static_cast<float>(column) / static_cast<float>(round);
      const SinCos turn = sincos_degrees(360 * u);
      for (const float value : {tilt.cosine * turn.sine, tilt.sine, tilt.cosine * turn.cosine}) {
        ball.positions.push_back(value);
        ball.normals.push_back(value);
      }
      ball.uvs.push_back(u);
      ball.uvs.push_back(v);
    }
  }
  const std::uint32_t wide = round + 1;
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < round; ++column) {
      const std::uint32_t a = row * wide + column, b = a + 1, c = a + wide, d = c + 1;
      // At the poles one of the two triangles has no area.
      if (row > 0) ball.indices.insert(ball.indices.end(), {a, b, d});
      if (row + 1 < rows) ball.indices.insert(ball.indices.end(), {a, d, c});
    }
  }
  return ball;
}

}  // namespace panicle
