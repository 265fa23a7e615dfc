#include "environment/voxel_light.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/mathematics.hpp"

namespace panicle {
namespace {

// Turns that no two of many points on a spiral share.
constexpr float golden_angle = 137.50776f;

}  // namespace

std::vector<Lamp> overcast(std::uint32_t count) {
  std::vector<Lamp> lamps;
  const auto all = static_cast<float>(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    // Uniform on the disc below is cosine weighted above.
    const float square = (static_cast<float>(k) + 0.5f) / all, radius = std::sqrt(square);
    const auto [sine, cosine] = sincos_degrees(golden_angle * static_cast<float>(k));
    lamps.push_back({{radius * cosine, std::sqrt(1 - square), radius * sine}, 1 / all});
  }
  return lamps;
}

std::vector<Lamp> all_round(std::uint32_t count) {
  std::vector<Lamp> lamps;
  const auto all = static_cast<float>(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    // Uniform along the axis is uniform on the sphere (Archimedes).
    const float height = 1 - (2 * static_cast<float>(k) + 1) / all, radius = std::sqrt(1 - height * height);
    const auto [sine, cosine] = sincos_degrees(golden_angle * static_cast<float>(k));
    lamps.push_back({{radius * cosine, height, radius * sine}, 1 / all});
  }
  return lamps;
}

VoxelLight::VoxelLight(const glm::vec3& low, float edge, std::uint32_t x, std::uint32_t y, std::uint32_t z,
                       std::span<const float> matter, std::span<const Lamp> lamps)
    : low_(low),
      edge_(edge),
      count_{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), static_cast<std::int32_t>(z)},
      light_(matter.size(), 0.0f) {
  for (const Lamp& lamp : lamps) shine(lamp, matter);
}

std::size_t VoxelLight::index(std::int32_t x, std::int32_t y, std::int32_t z) const {
  return static_cast<std::size_t>((z * count_[1] + y) * count_[0] + x);
}

// Layer by layer away from the lamp, across the axis that it lies nearest to: what a cell's middle is behind is what
// the place towards the lamp in the layer before is behind, and the matter on the way.
void VoxelLight::shine(const Lamp& lamp, std::span<const float> matter) {
  int main = 0;
  for (int k = 1; k < 3; ++k)
    if (std::fabs(lamp.towards[k]) > std::fabs(lamp.towards[main])) main = k;
  const int across = (main + 1) % 3, along = (main + 2) % 3;
  const float step = 1 / std::fabs(lamp.towards[main]);  // from layer to layer, in cells
  const float shift_across = lamp.towards[across] * step, shift_along = lamp.towards[along] * step;
  const std::int32_t layers = count_[main];
  const auto plane = static_cast<std::size_t>(count_[across]) * static_cast<std::size_t>(count_[along]);
  std::vector<float> before(plane, 0.0f), depth(plane, 0.0f), matter_before(plane, 0.0f), matter_here(plane);
  const auto cell = [&](std::int32_t layer, std::int32_t u, std::int32_t v) {
    std::int32_t at[3];
    at[main] = layer;
    at[across] = u;
    at[along] = v;
    return index(at[0], at[1], at[2]);
  };
  // Towards the lamp lie four places of the layer before, the same ones for each cell; what lies beside the box is
  // empty.
  const float low_across = std::floor(shift_across), low_along = std::floor(shift_along);
  const auto by_u = static_cast<std::int32_t>(low_across), by_v = static_cast<std::int32_t>(low_along);
  const float share_u = shift_across - low_across, share_v = shift_along - low_along, way = 0.5f * step * edge_;
  const auto behind = [&](std::int32_t u, std::int32_t v) {
    float sum = 0;
    for (std::int32_t j = 0; j < 2; ++j)
      for (std::int32_t i = 0; i < 2; ++i) {
        const std::int32_t at_u = u + by_u + i, at_v = v + by_v + j;
        if (at_u < 0 || at_v < 0 || at_u >= count_[across] || at_v >= count_[along]) continue;
        const auto at = static_cast<std::size_t>(at_v * count_[across] + at_u);
        sum += (i ? share_u : 1 - share_u) * (j ? share_v : 1 - share_v) * (before[at] + way * matter_before[at]);
      }
    return sum;
  };
  for (std::int32_t k = 0; k < layers; ++k) {
    const std::int32_t layer = lamp.towards[main] > 0 ? layers - 1 - k : k;
    for (std::int32_t v = 0; v < count_[along]; ++v)
      for (std::int32_t u = 0; u < count_[across]; ++u) {
        const auto at = static_cast<std::size_t>(v * count_[across] + u);
        const float here = matter[cell(layer, u, v)];
        matter_here[at] = here;
        depth[at] = behind(u, v) + way * here;
        light_[cell(layer, u, v)] += lamp.share * exponential(-depth[at]);
      }
    std::swap(before, depth);
    std::swap(matter_before, matter_here);
  }
}

float VoxelLight::at(const glm::vec3& p) const {
  std::int32_t cell[3], next[3];
  float share[3];
  for (int k = 0; k < 3; ++k) {
    const float place = std::clamp((p[k] - low_[k]) / edge_ - 0.5f, 0.0f, static_cast<float>(count_[k] - 1));
    cell[k] = static_cast<std::int32_t>(place);
    next[k] = std::min(cell[k] + 1, count_[k] - 1);
    share[k] = place - static_cast<float>(cell[k]);
  }
  const auto mix = [](float a, float b, float t) { return a + t * (b - a); };
  const auto row = [&](std::int32_t y, std::int32_t z) {
    return mix(light_[index(cell[0], y, z)], light_[index(next[0], y, z)], share[0]);
  };
  return mix(mix(row(cell[1], cell[2]), row(next[1], cell[2]), share[1]),
             mix(row(cell[1], next[2]), row(next[1], next[2]), share[1]), share[2]);
}

}  // namespace panicle
