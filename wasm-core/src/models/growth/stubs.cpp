#include "models/growth/stubs.hpp"

#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "foundation/rotation.hpp"
#include "mesh/normals.hpp"

namespace panicle::growth {
namespace {

constexpr std::uint64_t stream_splinters = 0x73747562;
constexpr std::uint32_t disc_sides = 16, splinter_sides = 22;
constexpr float dome = 0.06f, rim = 1.015f;  // of a saw cut, in radii
// Splinters, in radii: the least and the greatest height above the end, how far their ring reaches down over the bark,
// and the depth of the hollow between them.
constexpr float least_splinter = 0.1f, longest_splinter = 2.2f, overlap = 0.25f, hollow = 0.35f;

// The end of a shoot: its place, the unit vector that it points to, and its radius.
struct End {
  glm::vec3 at{0}, along{0};
  float radius = 0;
};

// Adds the disc of a saw cut, slightly domed.
void add_cut(const End& end, Mesh& mesh) {
  const glm::vec3 x = any_perpendicular(end.along), z = glm::cross(x, end.along);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
  const auto vertex = [&](float radius, float turns, float up) {
    const SinCos turn = sincos_degrees(360 * turns);
    const glm::vec3 out = turn.cosine * x + turn.sine * z;
    put(mesh.positions, end.at + end.radius * (radius * out + up * end.along));
    put(mesh.normals, glm::normalize(end.along + 0.3f * radius * out));
    put(mesh.uvs, glm::vec2(0.5f + 0.5f * radius * turn.cosine, 0.5f + 0.5f * radius * turn.sine));
  };
  vertex(0, 0, dome);
  for (std::uint32_t i = 0; i < disc_sides; ++i)
    vertex(rim, static_cast<float>(i) / static_cast<float>(disc_sides), 0.01f);
  for (std::uint32_t i = 0; i < disc_sides; ++i)
    put(mesh.indices, first, first + 1 + (i + 1) % disc_sides, first + 1 + i);
}

// Adds the splinters of a broken end: a ring from the bark up to uneven tips, longer on one side, and down to a hollow.
void add_splinters(const End& end, const RandomStream& noise, std::uint64_t address, Mesh& mesh) {
  const glm::vec3 x = any_perpendicular(end.along), z = glm::cross(x, end.along);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
  const float long_side = noise.unit(address);
  const auto vertex = [&](float radius, float turns, float up) {
    const SinCos turn = sincos_degrees(360 * turns);
    put(mesh.positions, end.at + end.radius * (radius * (turn.cosine * x + turn.sine * z) + up * end.along));
    put(mesh.uvs, glm::vec2(turns, 0.3f * up));
  };
  for (std::uint32_t i = 0; i < splinter_sides; ++i) {
    const float turns = static_cast<float>(i) / static_cast<float>(splinter_sides);
    const auto [height, inward] = noise.units(hash_combine(address, i + 1));
    const float side = 0.5f + 0.5f * sincos_degrees(360 * (turns - long_side)).cosine;
    const float tip = i % 2 == 0 ? height * (0.25f + 0.75f * side) : 0.15f * height;
    vertex(1.01f, turns, -overlap);
    vertex(0.97f - 0.15f * inward, turns, least_splinter + (longest_splinter - least_splinter) * tip);
    vertex(0.55f, turns, -hollow * (0.5f + height));
  }
  vertex(0, 0, -hollow);
  const std::uint32_t middle = first + 3 * splinter_sides;
  for (std::uint32_t i = 0; i < splinter_sides; ++i) {
    const std::uint32_t here = first + 3 * i, next = first + 3 * ((i + 1) % splinter_sides);
    put(mesh.indices, here, here + 1, next);
    put(mesh.indices, next, here + 1, next + 1);
    put(mesh.indices, here + 1, here + 2, next + 1);
    put(mesh.indices, next + 1, here + 2, next + 2);
    put(mesh.indices, here + 2, middle, next + 2);
  }
}

}  // namespace

std::vector<std::uint8_t> dead_segments(const Moment& moment, const Form& form) {
  if (form.edited.empty()) return {};
  const std::size_t count = moment.segments.size();
  std::vector<std::uint8_t> dead(count, 0), lives_on(count, 0);  // lives_on: something alive grows from its end
  bool any = false;
  for (std::size_t i = count; i-- > 0;) {
    const EditedShoot& edited = form.edited[static_cast<std::size_t>(moment.axes[i])];
    dead[i] = edited.dead || (edited.snapped && !lives_on[i]) ? 1 : 0;
    any |= dead[i] != 0;
    if (!dead[i] && moment.segments[i].parent >= 0) lives_on[static_cast<std::size_t>(moment.segments[i].parent)] = 1;
  }
  if (!any) dead.clear();
  return dead;
}

StubMeshes stub_meshes(const Moment& moment, const Form& form, std::uint64_t seed) {
  StubMeshes stubs;
  const RandomStream noise(seed, stream_splinters);
  for (std::uint32_t q = 0; q < form.edited.size(); ++q) {
    const ShootPath& path = form.paths[q];
    if (!form.edited[q].cut || path.count == 0) continue;
    const std::int32_t last = moment.of_node[path.first + path.count];
    if (last < 0) continue;
    const Segment& segment = moment.segments[static_cast<std::size_t>(last)];
    const float length = glm::distance(segment.start, segment.end);
    if (!(length > 0)) continue;
    const End end{segment.end, (segment.end - segment.start) / length, segment.radius_end};
    if (form.edited[q].snapped)
      add_splinters(end, noise, q, stubs.splinters);
    else
      add_cut(end, stubs.cuts);
  }
  set_normals(stubs.splinters);
  return stubs;
}

}  // namespace panicle::growth
