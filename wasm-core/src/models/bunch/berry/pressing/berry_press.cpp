#include "models/bunch/berry/pressing/berry_press.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/easing.hpp"
#include "foundation/lanes.hpp"

namespace panicle::bunch {
namespace {

// How far round a rim the surface bends, over the berry's radius: as far as the dent is deep, within these bounds, so
// that even a shallow one touches its plane.
constexpr float softest = 0.12f, hardest = 0.03f;
constexpr float rubbed = 0.03f;  // a skin this near to a plane is marked, over the berry's radius
constexpr float volume_error = 1e-3f;

// The greater of two values, lane by lane.
Four maximum(const Four& a, const Four& b) { return a > b ? a : b; }
// Four times the same value.
Four four(float v) { return Four{v, v, v, v}; }

// A rounded maximum of two values, and the first one's share in its derivatives.
struct Blend {
  Four value, share;
};

// The greater of a and b; where they differ by less than `soft` rounded up by a cubic, soft/6 at most, so that the
// second derivative is continuous.
Blend soft_maximum(const Four& a, const Four& b, const Four& soft) {
  const Four zero = four(0);
  const Four difference = a - b;
  const Four near = maximum(zero, 1 - maximum(difference, -difference) / soft);
  const Four half = near * near * 0.5f;
  return {maximum(a, b) + near * half * soft * (1 / 3.0f), difference > zero ? 1 - half : half};
}

}  // namespace

BerryPress::BerryPress(const BerryPattern& pattern)
    : pattern_(pattern), planes_(pattern.padded()), soft_(pattern.padded()), radius_(pattern.padded()) {}

// Presses a berry of the free form `free` flat against the planes, and bulges the rest so that its volume is `volume`.
// Returns the missing share of the volume; 0 if it fits.
float BerryPress::fit(const GaugeTable& free, std::span<const BerryPlane> planes, float volume) {
  free_ = &free;
  nearest_ = *std::min_element(free.value.begin(), free.value.end()) / max_bulge;
  clip(planes);
  return bulge_to(volume);
}

// Presses a berry flat where it touches others: for each direction the smooth maximum of the planes that cut it.
void BerryPress::clip(std::span<const BerryPlane> planes) {
  for (auto* values : {&planes_.value, &planes_.x, &planes_.y, &planes_.z}) {
    std::fill(values->begin(), values->end(), 0.0f);
  }
  std::fill(soft_.begin(), soft_.end(), softest);
  // A plane below this gauge has no effect, not even through another that it is blended with.
  const float least = nearest_ - 2 * softest;
  const auto& [ex, ey, ez] = pattern_.directions;
  for (const BerryPlane& face : planes) {
    const glm::vec3& slope = face.slope;
    if (glm::dot(slope, slope) < least * least) continue;
    const Four own_soft = four(std::clamp(face.depth, hardest, softest));
    for (std::size_t i = 0; i < pattern_.padded(); i += 4) {
      const Four plane = load(&ex[i]) * slope.x + load(&ey[i]) * slope.y + load(&ez[i]) * slope.z;
      if (all(plane < least)) continue;
      const Four soft = load(&soft_[i]);
      const Blend blend = soft_maximum(plane, load(&planes_.value[i]), own_soft < soft ? own_soft : soft);
      const Four rest = 1 - blend.share;
      store(&planes_.value[i], blend.value);
      store(&planes_.x[i], slope.x * blend.share + load(&planes_.x[i]) * rest);
      store(&planes_.y[i], slope.y * blend.share + load(&planes_.y[i]) * rest);
      store(&planes_.z[i], slope.z * blend.share + load(&planes_.z[i]) * rest);
      store(&soft_[i], own_soft * blend.share + soft * rest);
    }
  }
}

// Sums the vertices' cones and their derivative by the bulge: fast, but a little too much where the surface is flat.
BerryPress::Volume BerryPress::rough_volume() {
  const Four shrink = four(1 / bulge_);
  Four sum = four(0), slope = four(0);
  for (std::size_t i = 0; i < pattern_.padded(); i += 4) {
    const Four free_gauge = load(&free_->value[i]) * shrink;
    const Blend blend = soft_maximum(free_gauge, load(&planes_.value[i]), load(&soft_[i]));
    const Four radius = 1 / blend.value;
    const Four part = load(&pattern_.shares[i]) * radius * radius * radius;
    store(&radius_[i], radius);
    sum += part;
    slope += part * radius * blend.share * free_gauge;
  }
  return {sum[0] + sum[1] + (sum[2] + sum[3]), 3 * (slope[0] + slope[1] + (slope[2] + slope[3]))};
}

// The volume of the triangle mesh, by the tetrahedra from the centre.
float BerryPress::exact_volume() const {
  float sum = 0;
  const std::uint32_t* corner = pattern_.indices.data();
  for (const float cell : pattern_.cells) {
    sum += cell * radius_[corner[0]] * radius_[corner[1]] * radius_[corner[2]];
    corner += 3;
  }
  return sum;
}

// Finds the bulge by Newton's method on the rough volume, corrected so that the exact one comes out right. Returns the
// missing share of the volume.
float BerryPress::bulge_to(float volume) {
  bulge_ = 1.01f;
  float aim = volume;
  for (int round = 0; round < 3; ++round) {
    Volume rough{0, 0};
    for (int step = 0; step < 8; ++step) {
      rough = rough_volume();
      const float missing = aim - rough.value;
      if (std::fabs(missing) < 0.3f * volume_error * aim || (missing > 0 && bulge_ >= max_bulge)) break;
      const float change = missing / std::max(rough.slope, 0.05f * aim);
      bulge_ = std::clamp(bulge_ * (1 + std::clamp(change, -0.1f, 0.1f)), 0.8f, max_bulge);
    }
    const float exact = exact_volume();
    if (std::fabs(exact - volume) < volume_error * volume) return 0;
    if (bulge_ >= max_bulge && exact < volume) return 1 - exact / volume;
    aim = volume * rough.value / exact;
  }
  return 0;
}

// Writes the vertices of the pressed berry: positions, normals, and how hard each is pressed (0 … 255). Whole groups of
// four first, then the rest.
void BerryPress::write(const BerryFrame& frame, float* positions, float* normals, std::uint8_t* pressed) const {
  const std::size_t whole = pattern_.vertices / 4 * 4, rest = pattern_.vertices - whole;
  for (std::size_t i = 0; i < whole; i += 4) write_four(frame, i, positions + 3 * i, normals + 3 * i, pressed + i);
  if (rest == 0) return;
  float last_positions[12], last_normals[12];
  std::uint8_t last_pressed[4];
  write_four(frame, whole, last_positions, last_normals, last_pressed);
  std::copy_n(last_positions, 3 * rest, positions + 3 * whole);
  std::copy_n(last_normals, 3 * rest, normals + 3 * whole);
  std::copy_n(last_pressed, rest, pressed + whole);
}

// Writes four vertices from number `i` on: 12 floats of positions and of normals, and 4 bytes that mark skin near a
// neighbour: 255 where a plane presses, down to 0 at the distance `rubbed` from it.
void BerryPress::write_four(const BerryFrame& frame, std::size_t i, float* positions, float* normals,
                            std::uint8_t* pressed) const {
  const Four shrink = four(1 / bulge_);
  const glm::mat3& m = frame.axes;
  // Normals go by the inverse transposed: the axes are at right angles.
  const glm::mat3 n(m[0] / glm::dot(m[0], m[0]), m[1] / glm::dot(m[1], m[1]), m[2] / glm::dot(m[2], m[2]));
  const auto& [ex, ey, ez] = pattern_.directions;
  const auto put = [](float* out, const Four& x, const Four& y, const Four& z) {
    store(out, Four{x[0], y[0], z[0], x[1]});
    store(out + 4, Four{y[1], z[1], x[2], y[2]});
    store(out + 8, Four{z[2], x[3], y[3], z[3]});
  };
  const Four free_gauge = load(&free_->value[i]) * shrink, plane_gauge = load(&planes_.value[i]);
  const Blend blend = soft_maximum(free_gauge, plane_gauge, load(&soft_[i]));
  const Four radius = 1 / blend.value;
  const Four dx = load(&ex[i]), dy = load(&ey[i]), dz = load(&ez[i]);
  const Four x = dx * radius, y = dy * radius, z = dz * radius;
  put(positions, frame.centre.x + m[0].x * x + m[1].x * y + m[2].x * z,
      frame.centre.y + m[0].y * x + m[1].y * y + m[2].y * z, frame.centre.z + m[0].z * x + m[1].z * y + m[2].z * z);

  // The rounding adds a part to the gradient along the direction: just enough for Euler's identity.
  const Four free_share = blend.share * shrink, plane_share = 1 - blend.share;
  Four gx = load(&free_->x[i]) * free_share + load(&planes_.x[i]) * plane_share;
  Four gy = load(&free_->y[i]) * free_share + load(&planes_.y[i]) * plane_share;
  Four gz = load(&free_->z[i]) * free_share + load(&planes_.z[i]) * plane_share;
  const Four lacking = blend.value - (gx * dx + gy * dy + gz * dz);
  gx += lacking * dx;
  gy += lacking * dy;
  gz += lacking * dz;
  const Four nx = n[0].x * gx + n[1].x * gy + n[2].x * gz;
  const Four ny = n[0].y * gx + n[1].y * gy + n[2].y * gz;
  const Four nz = n[0].z * gx + n[1].z * gy + n[2].z * gz;
  const Four per_length = 1 / square_root(nx * nx + ny * ny + nz * nz);
  put(normals, nx * per_length, ny * per_length, nz * per_length);

  const Four depth = 1 + (plane_gauge - free_gauge) * (1 / rubbed);
  const Four inside = maximum(four(0), depth > four(1) ? four(1) : depth);
  const Four share = smooth(inside) * 255 + 0.5f;
  for (int lane = 0; lane < 4; ++lane) pressed[lane] = static_cast<std::uint8_t>(share[lane]);
}

}  // namespace panicle::bunch
