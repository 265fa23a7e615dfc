#include "light/voxel_light.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/golden_spiral.hpp"
#include "foundation/lanes.hpp"
#include "foundation/mathematics.hpp"

namespace panicle {
namespace {

constexpr std::size_t lanes = 4;

// Loads up to four of `count` values that are `stride` apart, from `at` on; 0 in the other lanes.
Four load_strided(const float* at, std::size_t stride, std::size_t count) {
  if (count >= lanes) return Four{at[0], at[stride], at[2 * stride], at[3 * stride]};
  return Four{at[0], count > 1 ? at[stride] : 0, count > 2 ? at[2 * stride] : 0, 0};
}

}  // namespace

// Directions of an overcast sky: evenly weighted, denser towards the zenith (cosine-weighted).
std::vector<LightDirection> overcast(std::uint32_t count) {
  std::vector<LightDirection> lamps;
  const auto all = static_cast<float>(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    // Points uniform on the disc below give cosine-weighted directions above.
    const glm::vec2 place = golden_disc_point(k, count);
    const float square = (static_cast<float>(k) + 0.5f) / all;
    lamps.push_back({{place.x, std::sqrt(1 - square), place.y}, 1 / all});
  }
  return lamps;
}

// Directions evenly over the whole sphere.
std::vector<LightDirection> all_round(std::uint32_t count) {
  std::vector<LightDirection> lamps;
  const auto all = static_cast<float>(count);
  for (std::uint32_t k = 0; k < count; ++k) lamps.push_back({golden_sphere_point(k, count), 1 / all});
  return lamps;
}

// Computes the light in all cells of a grid: the sum over all directions of their share times e to the power of minus
// the optical depth. `matter` is the density of each cell, x fastest.
VoxelLight::VoxelLight(const glm::vec3& low, float edge, std::uint32_t x, std::uint32_t y, std::uint32_t z,
                       std::span<const float> matter, std::span<const LightDirection> lamps)
    : low_(low),
      edge_(edge),
      count_{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), static_cast<std::int32_t>(z)},
      light_(matter.size(), 0.0f) {
  Planes planes;
  for (const LightDirection& lamp : lamps) shine(lamp, matter, planes);
}

// The numbers of cells along x, y and z.
std::array<std::uint32_t, 3> VoxelLight::counts() const {
  return {static_cast<std::uint32_t>(count_[0]), static_cast<std::uint32_t>(count_[1]),
          static_cast<std::uint32_t>(count_[2])};
}

// The index of a cell.
std::size_t VoxelLight::index(std::int32_t x, std::int32_t y, std::int32_t z) const {
  return static_cast<std::size_t>((z * count_[1] + y) * count_[0] + x);
}

// Sweeps layer by layer away from the light, along its dominant axis: the optical depth at a cell's middle is that at
// the place towards the light in the layer before, plus the matter on the way.
void VoxelLight::shine(const LightDirection& lamp, std::span<const float> matter, Planes& planes) {
  int main = 0;
  for (int k = 1; k < 3; ++k)
    if (std::fabs(lamp.towards[k]) > std::fabs(lamp.towards[main])) main = k;
  const int across = main == 0 ? 1 : 0, along = 3 - main - across;
  const std::size_t strides[3] = {1, index(0, 1, 0), index(0, 0, 1)};
  const auto width = static_cast<std::size_t>(count_[across]), height = static_cast<std::size_t>(count_[along]),
             layers = static_cast<std::size_t>(count_[main]), stride = strides[across];
  // The place towards the light lies among four cells of the layer before, at the same offsets for each cell. Cells
  // beside the box are empty: a border of the planes, which have room for the last cells of a row as lanes.
  const std::size_t pitch = width + 1 + lanes;
  auto& [before, here] = planes;
  before.assign(pitch * (height + 2), 0.0f);
  here.assign(before.size(), 0.0f);
  const float step = 1 / std::fabs(lamp.towards[main]);  // from layer to layer, in cells
  const float sideways = lamp.towards[across] * step, up = lamp.towards[along] * step, way = 0.5f * step * edge_;
  const std::size_t nearest = (up < 0 ? 0 : pitch) + (sideways < 0 ? 0 : 1);
  const float u = sideways < 0 ? sideways + 1 : sideways, v = up < 0 ? up + 1 : up;
  for (std::size_t k = 0; k < layers; ++k) {
    const std::size_t layer = (lamp.towards[main] > 0 ? layers - 1 - k : k) * strides[main];
    for (std::size_t row = 0; row < height; ++row) {
      const float *near = &before[row * pitch + nearest], *far = near + pitch;
      float* left = &here[(row + 1) * pitch + 1];
      for (std::size_t x = 0; x < width; x += lanes) {
        const std::size_t first = layer + row * strides[along] + x * stride, count = std::min(lanes, width - x);
        const Four some = way * load_strided(&matter[first], stride, count);
        const Four depth = (1 - v) * ((1 - u) * load(near + x) + u * load(near + x + 1)) +
                           v * ((1 - u) * load(far + x) + u * load(far + x + 1)) + some;
        store(left + x, depth + some);
        const Four light = lamp.share * exponential(-depth);
        for (std::size_t lane = 0; lane < count; ++lane) light_[first + lane * stride] += light[lane];
      }
      left[width] = 0;
    }
    std::swap(before, here);
  }
}

// Finds the eight cells whose middles surround a place. A place beyond the outermost middles is moved to them.
VoxelLight::Corner VoxelLight::corner_of(const glm::vec3& p) const {
  const FourIntegers strides = {1, count_[0], count_[0] * count_[1], 0};
  const FourIntegers last = {count_[0] - 1, count_[1] - 1, count_[2] - 1, 0};
  const Four from = {p.x - low_.x, p.y - low_.y, p.z - low_.z, 0}, most = __builtin_convertvector(last, Four);
  Four place = from / edge_ - 0.5f;
  place = place > 0.0f ? place : Four{};
  place = place < most ? place : most;
  const FourIntegers cell = __builtin_convertvector(place, FourIntegers);
  const FourIntegers lower = cell * strides, upper = (cell < last ? cell + 1 : last) * strides;
  const Four share = place - __builtin_convertvector(cell, Four);
  Corner corner;
  for (int k = 0; k < 3; ++k) {
    corner.lower[k] = static_cast<std::size_t>(lower[k]);
    corner.upper[k] = static_cast<std::size_t>(upper[k]);
    corner.share[k] = share[k];
  }
  return corner;
}

// The light at a point, interpolated between the eight cells around it.
float VoxelLight::at(const glm::vec3& p) const {
  const Corner at = corner_of(p);
  // The four rows along x.
  const std::size_t rows[4] = {at.lower[1] + at.lower[2], at.upper[1] + at.lower[2], at.lower[1] + at.upper[2],
                               at.upper[1] + at.upper[2]};
  const float *const left = &light_[at.lower[0]], *const right = &light_[at.upper[0]];
  const Four one = {left[rows[0]], left[rows[1]], left[rows[2]], left[rows[3]]},
             other = {right[rows[0]], right[rows[1]], right[rows[2]], right[rows[3]]};
  const Four along = one + at.share[0] * (other - one);
  const auto mix = [](float a, float b, float t) { return a + t * (b - a); };
  return mix(mix(along[0], along[1], at.share[1]), mix(along[2], along[3], at.share[1]), at.share[2]);
}

// The light at four points.
Four VoxelLight::at(const FourVectors& p) const {
  FourIntegers lower[3], upper[3];
  Four share[3];
  const Four from[3] = {p.x - low_.x, p.y - low_.y, p.z - low_.z};
  std::int32_t stride = 1;
  for (int k = 0; k < 3; ++k) {
    const std::int32_t last = count_[k] - 1;
    const Four most = all_of(static_cast<float>(last));
    Four place = from[k] / edge_ - 0.5f;
    place = place > 0.0f ? place : Four{};
    place = place < most ? place : most;
    const FourIntegers cell = __builtin_convertvector(place, FourIntegers);
    share[k] = place - __builtin_convertvector(cell, Four);
    lower[k] = cell * stride;
    upper[k] = lower[k] + (FourIntegers)((cell < last) & FourIntegers{stride, stride, stride, stride});
    stride *= count_[k];
  }
  const float* const light = light_.data();
  const auto mix = [](const Four& a, const Four& b, const Four& t) { return a + t * (b - a); };
  const auto row = [&](const FourIntegers& begin) {
    const FourIntegers left = begin + lower[0], right = begin + upper[0];
    return mix(Four{light[left[0]], light[left[1]], light[left[2]], light[left[3]]},
               Four{light[right[0]], light[right[1]], light[right[2]], light[right[3]]}, share[0]);
  };
  return mix(mix(row(lower[1] + lower[2]), row(upper[1] + lower[2]), share[1]),
             mix(row(lower[1] + upper[2]), row(upper[1] + upper[2]), share[1]), share[2]);
}

// The gradient of light at a point, in light per unit of length.
glm::vec3 VoxelLight::ascent(const glm::vec3& p) const {
  const Corner at = corner_of(p);
  glm::vec3 ascent(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t one = (k + 1) % 3, other = (k + 2) % 3;
    for (int i = 0; i < 4; ++i) {
      const bool up = (i & 1) != 0, far = (i & 2) != 0;
      const std::size_t beside = (up ? at.upper[one] : at.lower[one]) + (far ? at.upper[other] : at.lower[other]);
      const float share = (up ? at.share[one] : 1 - at.share[one]) * (far ? at.share[other] : 1 - at.share[other]);
      ascent[static_cast<int>(k)] += share * (light_[at.upper[k] + beside] - light_[at.lower[k] + beside]);
    }
  }
  return ascent / edge_;
}

}  // namespace panicle
