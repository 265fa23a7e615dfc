#include "models/particles/crown_light.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::particles {
namespace {

constexpr std::uint32_t directions = 24;

}  // namespace

std::vector<Lamp> lamps_of(const LightHabit& habit) {
  std::vector<Lamp> lamps;
  if (habit.sky > 0) lamps = overcast(directions);
  for (Lamp& lamp : lamps) lamp.share *= habit.sky;
  if (habit.sky < 1) lamps.push_back({habit.sun, 1 - habit.sky});
  return lamps;
}

glm::vec3 towards_sun(float bearing, float height) {
  const auto [sine, cosine] = sincos_degrees(bearing);
  const auto [up, along] = sincos_degrees(height);
  return {along * sine, up, along * cosine};
}

VoxelLight light_in(const Region& crown, std::span<const Box> others, const LightHabit& habit, std::uint32_t cells) {
  glm::vec3 first = crown.low(), last = crown.high();
  for (const Box& other : others) {
    first = glm::min(first, other.low);
    last = glm::max(last, other.high);
  }
  const glm::vec3 size = last - first;
  const auto leafy = [&](const glm::vec3& p) {
    return crown.contains(p) ||
           std::any_of(others.begin(), others.end(), [&](const Box& other) { return within_round(other, p); });
  };
  const float edge = std::max({size.x, size.y, size.z, 1e-6f}) / static_cast<float>(cells);
  const auto count = [&](float length) { return static_cast<std::uint32_t>(std::ceil(length / edge)) + 1; };
  const std::uint32_t x = count(size.x), y = count(size.y), z = count(size.z);
  const glm::vec3 low = first - 0.5f * edge;
  std::vector<float> matter;
  matter.reserve(std::size_t{x} * y * z);
  for (std::uint32_t k = 0; k < z; ++k)
    for (std::uint32_t j = 0; j < y; ++j)
      for (std::uint32_t i = 0; i < x; ++i)
        matter.push_back(leafy(low + edge * (glm::vec3(i, j, k) + 0.5f)) ? habit.absorption : 0);
  return {low, edge, x, y, z, matter, lamps_of(habit)};
}

}  // namespace panicle::particles
