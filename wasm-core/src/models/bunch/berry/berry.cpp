#include "models/bunch/berry/berry.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/easing.hpp"
#include "foundation/mathematics.hpp"

namespace panicle::bunch {
namespace {

// Distance of the surface from the centre, `from_tip` radians away from +Y, and how it changes.
struct Meridian {
  float radius, slope;
};

// The radius of a grape at an angle from its tip, over that of a ball, and the radius's slope.
Meridian meridian(float from_tip) {
  struct Feature {
    float height, width, at;
  };
  constexpr Feature features[] = {
      {-0.040f, 0.34f, 0},   // dimple round the scar
      {0.026f, 0.11f, 0},    // the rest of the style inside it
      {-0.022f, 0.70f, pi},  // the seat
  };
  Meridian result{1, 0};
  for (const Feature& feature : features) {
    const float x = (from_tip - feature.at) / feature.width;
    result.radius += feature.height * hill(x);
    result.slope += feature.height / feature.width * slope_of_hill(x);
  }
  return result;
}

// A parallel of the berry: radius and height, the normal's parts outward and up, and the texture coordinate v (1 at the
// tip, 0 at the seat).
struct Parallel {
  float radius, height, normal_out, normal_up, v;
};

// The parallel at `along`, from the tip (0) to the seat (1). Parallels crowd towards the tip, where the dimple is.
Parallel parallel_at(float along) {
  const float degrees = 180 * along * (0.32f + 0.68f * along);
  const SinCos angle = sincos_degrees(degrees);
  const Meridian m = meridian(degrees * (pi / 180));
  const float out = m.slope * angle.sine + m.radius * angle.cosine;  // derivatives of radius and height
  const float up = m.slope * angle.cosine - m.radius * angle.sine;
  const float length = std::sqrt(out * out + up * up);
  return {m.radius * angle.sine, m.radius * angle.cosine, -up / length, out / length, 1 - degrees / 180};
}

// Collects the vertices and triangles of a mesh.
class Builder {
 public:
  // Reserves space for that many vertices and triangles.
  explicit Builder(std::uint32_t vertices, std::uint32_t triangles) {
    mesh_.positions.reserve(3 * vertices);
    mesh_.normals.reserve(3 * vertices);
    mesh_.uvs.reserve(2 * vertices);
    mesh_.indices.reserve(3 * triangles);
  }

  // Adds the vertex of the parallel `p` at an angle about the axis of the berry; `u`: texture coordinate round the
  // berry.
  void vertex(const Parallel& p, const SinCos& around, float u) {
    mesh_.positions.insert(mesh_.positions.end(), {p.radius * around.cosine, p.height, p.radius * around.sine});
    mesh_.normals.insert(mesh_.normals.end(), {p.normal_out * around.cosine, p.normal_up, p.normal_out * around.sine});
    mesh_.uvs.insert(mesh_.uvs.end(), {u, p.v});
  }

  // Adds a triangle of three vertices.
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
  }

  Mesh take() { return std::move(mesh_); }

 private:
  Mesh mesh_;
};

}  // namespace

// The mesh of one grape of radius 1 about the origin with its tip at +Y; all berries without a shape of their own share
// it.
Mesh make_berry(const BerryOptions& options) {
  const std::uint32_t segments = std::clamp(options.segments, 6u, 128u);
  const std::uint32_t parallels = segments * 3 / 4;
  const std::uint32_t row = segments + 1;
  Builder builder(row * parallels + 2 * segments, 2 * segments * parallels);
  const auto step = [segments](float i) { return i / static_cast<float>(segments); };

  // Rows of parallels from the tip down, then a pole for each segment, so that u stays within the segment at the poles.
  for (std::uint32_t j = 1; j <= parallels; ++j) {
    const Parallel p = parallel_at(static_cast<float>(j) / static_cast<float>(parallels + 1));
    for (std::uint32_t i = 0; i <= segments; ++i) {
      builder.vertex(p, sincos_degrees(360 * step(static_cast<float>(i % segments))), step(static_cast<float>(i)));
    }
  }
  for (const float along : {0.0f, 1.0f}) {
    Parallel pole = parallel_at(along);
    pole.radius = pole.normal_out = 0;
    for (std::uint32_t i = 0; i < segments; ++i) builder.vertex(pole, {0, 1}, step(static_cast<float>(i) + 0.5f));
  }

  const std::uint32_t tip = row * parallels;
  const std::uint32_t seat = tip + segments;
  const std::uint32_t last = row * (parallels - 1);
  for (std::uint32_t i = 0; i < segments; ++i) {
    builder.triangle(tip + i, i + 1, i);
    for (std::uint32_t at = i; at < last; at += row) {
      builder.triangle(at, at + 1, at + row + 1);
      builder.triangle(at, at + row + 1, at + row);
    }
    builder.triangle(seat + i, last + i, last + i + 1);
  }
  return builder.take();
}

}  // namespace panicle::bunch
