#include "stems/root_flare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "foundation/easing.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

namespace panicle {
namespace {

constexpr std::uint64_t stream_ridge = 0xf007;
// In radii of the trunk: the length of its vertical piece, and the height of the flare.
constexpr float upright = 0.5f, widens = 2.2f;
// A tube in the open begins wider by this share, up to so many radii.
constexpr float bell = 0.2f, bell_reach = 2.25f;
constexpr std::uint32_t around = 36, rings = 12;
// Between ridges a trunk is wider by `hollow` of the flare; the surface begins so far within the trunk.
constexpr float hollow = 0.3f, within = 0.14f;
constexpr std::uint32_t ridges = 6;
constexpr float ridge_width = 0.62f;  // of the way from ridge to ridge
constexpr float stem_width = 0.92f;

// The ridges of one trunk: at angles of their own, some higher than others.
class Ridges {
 public:
  // Random heights and directions of the ridges for a seed.
  explicit Ridges(std::uint64_t seed) {
    for (std::uint32_t k = 0; k < ridges; ++k) {
      turn_[k] = (static_cast<float>(k) + 0.7f * (random_unit(seed, stream_ridge, 2 * k) - 0.5f)) / ridges;
      size_[k] = 0.6f + 0.4f * random_unit(seed, stream_ridge, 2 * k + 1);
    }
  }

  // The height of the ridges, 0 … 1, at a share of a whole turn.
  float at(float turn) const {
    float height = 0;
    for (std::uint32_t k = 0; k < ridges; ++k) {
      float off = turn - turn_[k];
      off -= std::floor(off + 0.5f);
      height = std::max(height, size_[k] * hill(off * ridges / (2 * ridge_width)));
    }
    return height;
  }

 private:
  std::array<float, ridges> turn_{}, size_{};
};

// The surface of a trunk's flared foot. `flare` is its additional width over the radius.
struct FlareShape {
  const TrunkLine& trunk;
  float radius, flare;
  Ridges ridges;

  // A point of the surface; `turn` and `up` as shares, 0 … 1.
  glm::vec3 at(float turn, float up) const {
    const float low = (1 - up) * (1 - up) * (1 - up), height = up * widens;
    const float widened = flare * low * (hollow * low + (1 - hollow) * ridges.at(turn));
    const float out = radius * (1 + bell * hill(height / bell_reach) - within * smooth(up) + widened);
    const auto [s, c] = sincos_degrees(360 * turn);
    return trunk.at(height * radius) + out * glm::vec3(c, 0, s);
  }
};

// Writer of vertices and triangles, all of the segment `number`.
class Writer {
 public:
  Writer(StemMesh& stems, std::uint32_t number) : stems_(stems), number_(number) {}

  // Adds a vertex; returns its index.
  std::uint32_t vertex(const glm::vec3& place, const glm::vec3& normal, float u, float v) {
    Mesh& mesh = stems_.mesh;
    mesh.positions.insert(mesh.positions.end(), {place.x, place.y, place.z});
    mesh.normals.insert(mesh.normals.end(), {normal.x, normal.y, normal.z});
    mesh.uvs.insert(mesh.uvs.end(), {u, v});
    stems_.segment.push_back(number_);
    return static_cast<std::uint32_t>(stems_.segment.size()) - 1;
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    stems_.mesh.indices.insert(stems_.mesh.indices.end(), {a, b, c});
  }

 private:
  StemMesh& stems_;
  std::uint32_t number_;
};

// Adds the flared surface around a trunk's foot as rings of vertices, from the ground up, and the disc that closes it
// below. Normals come from differences of points nearby.
void add_flare_surface(StemMesh& stems, const FlareShape& shape) {
  Writer writer(stems, static_cast<std::uint32_t>(shape.trunk.base));
  constexpr float step = 0.5f / around;
  std::uint32_t first = 0;
  for (std::uint32_t ring = 0; ring <= rings; ++ring) {
    // Rings are denser towards the ground.
    const float share = static_cast<float>(ring) / rings, up = share * share;
    for (std::uint32_t k = 0; k <= around; ++k) {
      const float turn = static_cast<float>(k % around) / around;
      const glm::vec3 along = shape.at(turn, std::min(up + 0.02f, 1.0f)) - shape.at(turn, std::max(up - 0.02f, 0.0f));
      const glm::vec3 round = shape.at(turn + step, up) - shape.at(turn - step, up);
      const std::uint32_t made = writer.vertex(shape.at(turn, up), glm::normalize(glm::cross(along, round)),
                                               static_cast<float>(k) / around, up * widens / (2 * pi));
      if (ring == 0 && k == 0) first = made;
    }
  }
  constexpr std::uint32_t row = around + 1;
  for (std::uint32_t ring = 0; ring < rings; ++ring)
    for (std::uint32_t k = 0; k < around; ++k) {
      const std::uint32_t at = first + ring * row + k;
      writer.triangle(at, at + row, at + row + 1);
      writer.triangle(at, at + row + 1, at + 1);
    }
  // The bottom disc.
  const glm::vec3 down(0, -1, 0);
  const std::uint32_t middle = writer.vertex(shape.trunk.at(0), down, 0.5f, 0);
  for (std::uint32_t k = 0; k <= around; ++k)
    writer.vertex(shape.at(static_cast<float>(k % around) / around, 0), down, static_cast<float>(k) / around, 0);
  for (std::uint32_t k = 0; k < around; ++k) writer.triangle(middle, middle + 1 + k, middle + 2 + k);
}

// The height of a trunk's vertical piece at its foot.
float upright_height(const Segment& base) {
  return std::min(upright * base.radius, 0.4f * (base.end.y - base.start.y));
}

}  // namespace

// By target, the thickest segment that begins there; −1 if there is none.
std::vector<std::int32_t> trunk_bases(std::span<const Segment> segments, std::span<const glm::vec3> targets) {
  std::vector<std::int32_t> bases(targets.size(), -1);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments[i].parent >= 0) continue;
    for (std::size_t k = 0; k < targets.size(); ++k) {
      if (segments[i].start != targets[k]) continue;
      std::int32_t& base = bases[k];
      if (base < 0 || segments[i].radius > segments[static_cast<std::size_t>(base)].radius)
        base = static_cast<std::int32_t>(i);
    }
  }
  return bases;
}

// The pieces that replace a trunk's first segment: a vertical one on the ground and the rest, or a stump in the soil
// before it.
std::vector<Segment> base_pieces(const Segment& base, const RootFlareOptions& options) {
  Segment rest = base, first = base;
  if (options.standing) {
    const float rise = upright_height(base);
    if (!(rise > 0)) return {base};
    first.end = rest.start = base.start + glm::vec3(0, rise, 0);
    first.radius_end = base.radius;
    return {first, rest};
  }
  if (!(options.stump > 0)) return {base};
  first.start.y += options.stump;
  first.end = base.start;
  first.radius = stem_width * base.radius;
  first.radius_end = base.radius;
  return {first, rest};
}

// The point of the trunk's axis at a height above the ground.
glm::vec3 TrunkLine::at(float height) const {
  const glm::vec3 ground = segments[base].start;
  const float y = ground.y + height;
  glm::vec3 from = ground + glm::vec3(0, upright_height(segments[base]), 0), to = from;
  if (y <= from.y) return {ground.x, y, ground.z};
  // Parents precede their children.
  std::size_t last = base;
  for (std::size_t i = base; i < segments.size(); ++i) {
    if (i != base && (axes[i] != axes[base] || segments[i].parent != static_cast<std::int32_t>(last))) continue;
    last = i;
    to = segments[i].end;
    if (to.y >= y) break;
    from = to;
  }
  const float reach = to.y - from.y;
  const glm::vec3 place = from + (reach > 0 ? std::min((y - from.y) / reach, 1.0f) : 0) * (to - from);
  return {place.x, y, place.z};
}

// Cuts a trunk's tube off at the ground, and adds the surface of its flared foot.
void add_root_flare(StemMesh& stems, const StemPart& tube, const TrunkLine& trunk, const RootFlareOptions& options) {
  if (!options.standing) return;
  const Segment& base = trunk.segments[trunk.base];
  std::vector<float>& positions = stems.mesh.positions;
  for (std::size_t v = tube.first_vertex; v < tube.first_vertex + tube.vertex_count; ++v)
    positions[3 * v + 1] = std::max(positions[3 * v + 1], base.start.y);
  if (options.flare > 0) add_flare_surface(stems, {trunk, base.radius, options.flare, Ridges(options.seed)});
}

}  // namespace panicle
