#include "stems/twigs.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "foundation/mathematics.hpp"
#include "foundation/rotation.hpp"

namespace panicle {
namespace {

constexpr std::uint32_t sides = 3;
constexpr float half = 0.8660254f;  // √3 / 2
constexpr std::array<glm::vec2, sides> corners{{{1, 0}, {-0.5f, half}, {-0.5f, -half}}};
constexpr std::int32_t none = -1;

// The unit direction of a segment; up if it has no length.
glm::vec3 direction_of(const Segment& segment) {
  const glm::vec3 way = segment.end - segment.start;
  const float length = glm::length(way);
  return length > 0 ? way / length : glm::vec3(0, 1, 0);
}

// The part of `v` at right angles to a unit vector, normalised; any perpendicular if `v` has none.
glm::vec3 perpendicular_part(const glm::vec3& v, const glm::vec3& tangent) {
  const glm::vec3 part = v - glm::dot(v, tangent) * tangent;
  if (glm::dot(part, part) > 1e-4f) return glm::normalize(part);
  return any_perpendicular(tangent, 0.8f);
}

class Writer {
 public:
  Writer(StemMesh& stem, float turns) : stem_(stem), turns_(turns) {}

  // Adds a vertex; returns its index.
  std::uint32_t vertex(const glm::vec3& place, const glm::vec3& normal, const glm::vec2& uv, std::size_t segment) {
    Mesh& mesh = stem_.mesh;
    put(mesh.positions, place);
    put(mesh.normals, normal);
    put(mesh.uvs, uv);
    stem_.segment.push_back(static_cast<std::uint32_t>(segment));
    return static_cast<std::uint32_t>(stem_.segment.size()) - 1;
  }
  // Writes a ring of three vertices around a place. Returns the index of the first.
  std::uint32_t ring(const glm::vec3& place, const glm::vec3& tangent, const glm::vec3& right, float radius, float v,
                     std::size_t segment) {
    const glm::vec3 forward = glm::cross(tangent, right);
    const auto first = static_cast<std::uint32_t>(stem_.segment.size());
    for (std::uint32_t k = 0; k < sides; ++k) {
      const glm::vec3 out = corners[k].x * right + corners[k].y * forward;
      vertex(place + radius * out, out, {turns_ * static_cast<float>(k) / sides, v}, segment);
    }
    return first;
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { put(stem_.mesh.indices, a, b, c); }

 private:
  StemMesh& stem_;
  float turns_;  // u once around
};

// The ring at the end of a segment: its first vertex, the direction of its first corner, and the texture coordinate.
struct End {
  std::uint32_t ring = 0;  // its first vertex
  glm::vec3 right{0};
  float v = 0;
};

}  // namespace

// Adds segments thinner than `fine` as tubes with three sides, without rounded joints.
void add_twigs(StemMesh& stem, std::span<const Segment> segments, std::span<const std::int32_t> axes, float fine,
               const BarkScale& bark) {
  // For each segment, the one that continues its axis.
  std::vector<std::int32_t> onward(segments.size(), none);
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (const std::int32_t parent = segments[i].parent;
        parent >= 0 && axes[static_cast<std::size_t>(parent)] == axes[i])
      onward[static_cast<std::size_t>(parent)] = static_cast<std::int32_t>(i);
  // A quarter of the bark's picture lies around a twig.
  const float turns = bark.width > 0 ? 0.25f : 1, stretch = bark.width > 0 ? turns * bark.width / bark.height : 1;
  Writer writer(stem, turns);
  std::vector<End> ends(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    if (!(segment.radius < fine)) continue;
    const glm::vec3 way = direction_of(segment);
    const auto parent = static_cast<std::size_t>(segment.parent);
    const bool carries_on = segment.parent >= 0 && onward[parent] == static_cast<std::int32_t>(i);
    // Begins at the ring of the segment before, or with a ring of its own.
    End from;
    if (carries_on && segments[parent].radius < fine) {
      from = ends[parent];
    } else {
      from.right = perpendicular_part(carries_on ? direction_of(segments[parent]) : glm::vec3(0, 1, 0), way);
      from.ring = writer.ring(segment.start, way, from.right, segment.radius, 0, i);
    }
    const float v = from.v + stretch * glm::distance(segment.start, segment.end) / (2 * pi * segment.radius);
    // The last segment of an axis ends in a point.
    if (onward[i] == none) {
      const std::uint32_t tip = writer.vertex(segment.end, way, {0.5f * turns, v}, i);
      for (std::uint32_t k = 0; k < sides; ++k) writer.triangle(from.ring + k, from.ring + (k + 1) % sides, tip);
      continue;
    }
    // Others end in a ring across the mean direction of both segments.
    const glm::vec3 both = way + direction_of(segments[static_cast<std::size_t>(onward[i])]);
    const glm::vec3 tangent = glm::length(both) > 0.1f ? glm::normalize(both) : way;
    End& end = ends[i];
    end.right = perpendicular_part(from.right, tangent);
    end.v = v;
    end.ring = writer.ring(segment.end, tangent, end.right, segment.radius_end, v, i);
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t next = (k + 1) % sides;
      writer.triangle(from.ring + k, from.ring + next, end.ring + next);
      writer.triangle(from.ring + k, end.ring + next, end.ring + k);
    }
  }
}

}  // namespace panicle
