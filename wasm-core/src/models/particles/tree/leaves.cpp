#include "models/particles/tree/leaves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/bits.hpp"
#include "foundation/easing.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

namespace panicle::particles::tree {
namespace {

constexpr std::uint64_t stream_tilt = 0x6c656166, stream_turn = stream_tilt + 1, stream_size = stream_tilt + 2,
                        stream_fall = stream_tilt + 3;
constexpr float golden_angle = 137.50776f;
constexpr float tilt = 0.45f;        // how far leaves look away from the light
constexpr float droop = 0.25f;       // of their tips
constexpr float least_size = 0.75f;  // of the largest
constexpr int needles = 5;
constexpr float rising = 0.6f;  // how long it takes until the highest leaves begin to unfold, of the time that all take

// Half widths along a blade, in halves of its width.
struct Station {
  float at, half;
};
constexpr std::array<Station, 6> pointed{
    {{0, 0.06f}, {0.14f, 0.62f}, {0.36f, 1}, {0.6f, 0.8f}, {0.82f, 0.36f}, {1, 0}}};
constexpr std::array<Station, 6> round_{
    {{0, 0.1f}, {0.1f, 0.66f}, {0.42f, 1}, {0.72f, 0.9f}, {0.92f, 0.5f}, {1, 0.06f}}};

void put_vertex(Mesh& mesh, const glm::vec3& p, const glm::vec3& normal, float u, float v) {
  mesh.positions.insert(mesh.positions.end(), {p.x, p.y, p.z});
  mesh.normals.insert(mesh.normals.end(), {normal.x, normal.y, normal.z});
  mesh.uvs.insert(mesh.uvs.end(), {u, v});
}

// Each half has normals of its own, so that the fold is sharp.
void add_half(Mesh& mesh, std::span<const Station> stations, float width, float fold, float side) {
  const auto [sine, cosine] = sincos_degrees(fold);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
  const glm::vec3 normal(-side * sine, 0, cosine);
  for (const Station& station : stations) {
    const float half = 0.5f * width * station.half;
    // A blade is arched: its tip bends down.
    const float arch = -0.12f * station.at * station.at;
    const glm::vec3 bent = glm::normalize(normal + glm::vec3(0, 0.24f * station.at, 0));
    put_vertex(mesh, {0, station.at, arch}, bent, 0.5f, station.at);
    put_vertex(mesh, {side * half * cosine, station.at, arch + half * sine}, bent, 0.5f + 0.5f * side * station.half,
               station.at);
  }
  for (std::uint32_t k = 0; k + 1 < stations.size(); ++k) {
    const std::uint32_t a = first + 2 * k, b = a + 1, c = a + 2, d = a + 3;
    const bool tip = stations[k + 1].half == 0;
    if (side > 0) {
      mesh.indices.insert(mesh.indices.end(), {a, b, c});
      if (!tip) mesh.indices.insert(mesh.indices.end(), {b, d, c});
    } else {
      mesh.indices.insert(mesh.indices.end(), {a, c, b});
      if (!tip) mesh.indices.insert(mesh.indices.end(), {b, c, d});
    }
  }
}

// Flat strips that spread from one place.
void add_needles(Mesh& mesh, float width) {
  for (int k = 0; k < needles; ++k) {
    const auto turn = sincos_degrees(360.0f * static_cast<float>(k) / needles + 15);
    const glm::vec3 way = glm::normalize(glm::vec3(0.45f * turn.cosine, 1, 0.45f * turn.sine));
    const glm::vec3 side = glm::normalize(glm::cross(way, glm::vec3(turn.cosine, 0, turn.sine)));
    const glm::vec3 normal = glm::cross(side, way);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
    put_vertex(mesh, -0.5f * width / needles * side, normal, 0, 0);
    put_vertex(mesh, 0.5f * width / needles * side, normal, 1, 0);
    put_vertex(mesh, way, normal, 0.5f, 1);
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
  }
}

float area_of(const Mesh& mesh) {
  float area = 0;
  const auto point = [&](std::uint32_t i) {
    return glm::vec3(mesh.positions[3 * i], mesh.positions[3 * i + 1], mesh.positions[3 * i + 2]);
  };
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const glm::vec3 a = point(mesh.indices[t]);
    area += 0.5f * glm::length(glm::cross(point(mesh.indices[t + 1]) - a, point(mesh.indices[t + 2]) - a));
  }
  return area;
}

// A vector at right angles to a unit vector.
glm::vec3 beside(const glm::vec3& way) {
  return glm::normalize(glm::cross(way, std::fabs(way.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
}

// The rotation that takes +Y to `up` and +Z to `front`, unit and at right angles, as a quaternion (Shepperd 1978).
glm::vec4 turn_to(const glm::vec3& up, const glm::vec3& front) {
  const glm::vec3 side = glm::cross(up, front);
  const float trace = side.x + up.y + front.z;
  glm::vec4 q;
  if (trace > 0)
    q = {up.z - front.y, front.x - side.z, side.y - up.x, 1 + trace};
  else if (side.x > up.y && side.x > front.z)
    q = {1 + side.x - up.y - front.z, up.x + side.y, front.x + side.z, up.z - front.y};
  else if (up.y > front.z)
    q = {up.x + side.y, 1 - side.x + up.y - front.z, front.y + up.z, front.x - side.z};
  else
    q = {front.x + side.z, front.y + up.z, 1 - side.x - up.y + front.z, side.y - up.x};
  return q / glm::length(q);
}

// A place keeps its luck wherever it stands among the others.
std::uint64_t luck_of(const glm::vec3& p) {
  const auto word = [](float value) { return std::uint64_t{bit_cast<std::uint32_t>(value)}; };
  return hash_combine(word(p.x) << 32 | word(p.y), word(p.z));
}

}  // namespace

Blade make_blade(LeafShape shape, float width, float fold) {
  Blade blade;
  if (shape == LeafShape::needle) {
    add_needles(blade.mesh, width);
  } else {
    const std::span<const Station> stations = shape == LeafShape::round ? round_ : pointed;
    add_half(blade.mesh, stations, width, fold, 1);
    add_half(blade.mesh, stations, width, fold, -1);
  }
  blade.area = area_of(blade.mesh);
  return blade;
}

void add_leaves(Plant& plant, const Trails& trails, std::span<const std::int32_t> numbers, const LeafHabit& habit,
                std::uint32_t tag) {
  float low = std::numeric_limits<float>::max(), high = -low;
  for (std::size_t i = 0; i < trails.size(); ++i)
    if (trails.particle[i] >= 0) {
      low = std::min(low, trails.places[i].y);
      high = std::max(high, trails.places[i].y);
    }
  for (std::size_t i = 0; i < trails.size(); ++i) {
    if (trails.particle[i] < 0 || numbers[i] < 0) continue;
    const float begins = high > low ? rising * (trails.places[i].y - low) / (high - low) : 0;
    const float share = smooth_step(begins, begins + 1 - rising, habit.unfolded);
    if (!(share > 0)) continue;
    const Segment& twig = plant.segments[static_cast<std::size_t>(numbers[i])];
    const glm::vec3 along = twig.end - twig.start;
    const float length = glm::length(along);
    const glm::vec3 way = length > 0 ? along / length : glm::vec3(0, 1, 0), side = beside(way),
                    across = glm::cross(way, side);
    const std::uint64_t place = luck_of(trails.places[i]);
    const float turn = 360 * random_unit(habit.seed, stream_turn, place);
    for (std::uint32_t k = 0; k < habit.count; ++k) {
      const std::uint64_t address = hash_combine(place, k);
      if (!(random_unit(habit.seed, stream_fall, address) < habit.kept)) continue;
      const float roll = turn + (habit.count == 2 ? 180.0f : golden_angle) * static_cast<float>(k);
      const auto [sine, cosine] = sincos_degrees(roll);
      glm::vec3 out = 0.6f * way + cosine * side + sine * across;
      glm::vec3 face = glm::normalize(habit.light + tilt * random_direction(habit.seed, stream_tilt, address));
      if (habit.needles)
        out = way + 0.5f * (cosine * side + sine * across);
      else
        out.y -= droop;
      glm::vec3 up = habit.needles ? out : out - glm::dot(out, face) * face;
      up = glm::length(up) > 1e-3f ? glm::normalize(up) : beside(face);
      const glm::vec3 front = face - glm::dot(face, up) * up;
      Organ leaf;
      leaf.tag = tag;
      leaf.segment = numbers[i];
      leaf.position = twig.end;
      leaf.rotation = turn_to(up, glm::length(front) > 1e-3f ? glm::normalize(front) : beside(up));
      leaf.scale = share * habit.size * (least_size + (1 - least_size) * random_unit(habit.seed, stream_size, address));
      plant.organs.push_back(leaf);
    }
  }
}

}  // namespace panicle::particles::tree
