#include "models/stand/ground.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

namespace panicle::stand {

// Waves of several lengths in random directions: each has half the height of the one before and is shorter by the
// golden ratio, so that no two places look alike.
Relief::Relief(const Ground& ground, std::uint64_t seed) : ground_(ground) {
  const std::uint64_t stream = hash_text("stand relief");
  const float length = ground.hills > 0 ? ground.hills : 0.5f * std::max(ground.width, ground.depth);
  float all = 0;
  for (std::uint32_t i = 0; i < waves; ++i) {
    const SinCos turn = sincos_degrees(360 * random_unit(seed, stream, 2 * i));
    const float shorter = power(1.618f, -static_cast<float>(i));
    number_[i] = 2 * pi / (length * shorter) * glm::vec2(turn.cosine, turn.sine);
    phase_[i] = 2 * pi * random_unit(seed, stream, 2 * i + 1);
    weight_[i] = power(0.5f, static_cast<float>(i));
    all += weight_[i];
  }
  for (float& weight : weight_) weight *= 0.5f * ground.relief / all;
}

// The ground's height at a place: the sum of all waves.
float Relief::at(float x, float z) const {
  if (ground_.relief <= 0) return 0;
  float height = 0;
  for (std::uint32_t i = 0; i < waves; ++i)
    height += weight_[i] * sine(number_[i].x * x + number_[i].y * z + phase_[i]);
  return height;
}

// Builds the ground as a grid of triangles, two cells a metre and at most 96 along each edge; normals from central
// differences of the height.
Mesh Relief::mesh() const {
  const auto cells = [&](float length) {
    return static_cast<std::uint32_t>(std::clamp(std::ceil(2 * length), 1.0f, 96.0f));
  };
  const std::uint32_t across = cells(ground_.width), deep = cells(ground_.depth);
  Mesh mesh;
  for (std::uint32_t j = 0; j <= deep; ++j)
    for (std::uint32_t i = 0; i <= across; ++i) {
      const float x = ground_.width * (static_cast<float>(i) / static_cast<float>(across) - 0.5f);
      const float z = ground_.depth * (static_cast<float>(j) / static_cast<float>(deep) - 0.5f);
      constexpr float step = 0.05f;
      const float slope_x = (at(x + step, z) - at(x - step, z)) / (2 * step);
      const float slope_z = (at(x, z + step) - at(x, z - step)) / (2 * step);
      put(mesh.positions, glm::vec3(x, at(x, z), z));
      put(mesh.normals, glm::normalize(glm::vec3(-slope_x, 1, -slope_z)));
      put(mesh.uvs, glm::vec2(x, z));
    }
  for (std::uint32_t j = 0; j < deep; ++j)
    for (std::uint32_t i = 0; i < across; ++i) {
      const std::uint32_t corner = j * (across + 1) + i;
      put(mesh.indices, corner, corner + across + 1, corner + 1);
      put(mesh.indices, corner + 1, corner + across + 1, corner + across + 2);
    }
  return mesh;
}

}  // namespace panicle::stand
