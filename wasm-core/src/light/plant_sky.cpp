#include "light/plant_sky.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"
#include "foundation/vectors.hpp"
#include "mesh/normals.hpp"

namespace panicle {
namespace {

constexpr float longest_piece = 16;          // of a stem, in radii
constexpr float max_pieces = 16;             // of a segment
constexpr std::uint32_t specks_a_part = 16;  // or a few more
constexpr std::uint32_t vertices_a_receiver = 16;
constexpr float flat = 0.5f;  // length of the mean normal from which triangles make a sheet

// Adds the triangles from `first` to before `end` as one speck, a small occluder: a disc if they face one way, else a
// ball.
void add_triangles(const Mesh& mesh, std::size_t first, std::size_t end, std::int32_t owner,
                   std::vector<SkyBody>& specks) {
  glm::vec3 middle(0), facing(0);
  float area = 0;
  for (std::size_t t = first; t < end; ++t) {
    const glm::vec3 a = vector_at(mesh.positions, mesh.indices[3 * t]),
                    b = vector_at(mesh.positions, mesh.indices[3 * t + 1]),
                    c = vector_at(mesh.positions, mesh.indices[3 * t + 2]);
    const glm::vec3 twice = triangle_normal(a, b, c);
    const float own = 0.5f * glm::length(twice);
    middle += (a + b + c) * (own / 3);
    facing += 0.5f * twice;
    area += own;
  }
  if (!(area > 0)) return;
  const float shown = glm::length(facing);
  SkyBody speck{middle / area, 0, glm::vec3(0), owner, -1};
  if (shown > flat * area) {
    speck.square = shown / pi;
    speck.facing = facing / shown;
  } else {
    speck.square = area / (4 * pi);  // a round part shows a quarter of its surface from every side
  }
  specks.push_back(speck);
}

}  // namespace

// Adds a stem's segment as specks: balls along it.
void add_specks(const Segment& segment, std::int32_t owner, std::vector<SkyBody>& specks) {
  const glm::vec3 way = segment.end - segment.start;
  const float length = glm::length(way), radius = 0.5f * (segment.radius + segment.radius_end);
  if (!(radius > 0)) return;
  const float pieces = std::clamp(std::ceil(length / (longest_piece * radius)), 1.0f, max_pieces);
  // A rod shows a quarter of its surface, as a mean over all directions.
  const float square = 0.5f * radius * length / pieces;
  for (float k = 0.5f; k < pieces; ++k)
    specks.push_back({segment.start + way * (k / pieces), square, glm::vec3(0), owner, segment.parent});
}

// Adds a part of a mesh as specks of several triangles each.
void add_specks(const Mesh& mesh, const MeshRange& part, std::int32_t owner, std::vector<SkyBody>& specks) {
  const std::size_t first = part.first_index / 3, end = first + part.index_count / 3;
  const std::size_t step = std::max<std::size_t>(1, (end - first) / specks_a_part);
  for (std::size_t t = first; t < end; t += step) add_triangles(mesh, t, std::min(t + step, end), owner, specks);
}

// The visible share of the sky at each vertex of stems, 0 … 255. Vertices of one segment share a receiver.
std::vector<std::uint8_t> sky_of_stems(Sky& sky, const StemMesh& stems, std::span<const Segment> segments) {
  const std::span<const float> positions(stems.mesh.positions), normals(stems.mesh.normals);
  std::vector<std::uint8_t> bytes(stems.segment.size());
  for (std::size_t first = 0, end = 0; first < bytes.size(); first = end) {
    const std::uint32_t segment = stems.segment[first];
    for (end = first + 1; end < bytes.size() && stems.segment[end] == segment;) ++end;
    const Segment& one = segments[segment];
    sky.set_receiver({0.5f * (one.start + one.end), 0.5f * glm::length(one.end - one.start),
                      static_cast<std::int32_t>(segment), one.parent});
    sky.sample(positions.subspan(3 * first, 3 * (end - first)), normals.subspan(3 * first, 3 * (end - first)),
               std::span(bytes).subspan(first, end - first));
  }
  return bytes;
}

// Sets the visible share of the sky at each vertex of a mesh's part; a sheet sees the sky from both sides.
void sample_part(Sky& sky, const Mesh& mesh, const MeshRange& part, std::int32_t owner, bool sheet,
                 std::span<std::uint8_t> bytes) {
  const std::size_t last = part.first_vertex + part.vertex_count;
  for (std::size_t first = part.first_vertex; first < last; first += vertices_a_receiver) {
    const std::size_t count = std::min<std::size_t>(vertices_a_receiver, last - first);
    SkyReceiver receiver{glm::vec3(0), 0, owner, -1};
    for (std::size_t v = first; v < first + count; ++v)
      receiver.centre += vector_at(mesh.positions, v) / static_cast<float>(count);
    for (std::size_t v = first; v < first + count; ++v)
      receiver.extent = std::max(receiver.extent, glm::distance(receiver.centre, vector_at(mesh.positions, v)));
    sky.set_receiver(receiver);
    const auto own = [&](const std::vector<float>& all) { return std::span(all).subspan(3 * first, 3 * count); };
    const auto into = bytes.subspan(first, count);
    sky.sample(own(mesh.positions), own(mesh.normals), into);
    if (!sheet) continue;
    float turned[3 * vertices_a_receiver];
    std::uint8_t below[vertices_a_receiver];
    std::transform(own(mesh.normals).begin(), own(mesh.normals).end(), turned, std::negate<>());
    sky.sample(own(mesh.positions), std::span(turned, 3 * count), std::span(below, count));
    for (std::size_t k = 0; k < count; ++k) into[k] = std::max(into[k], below[k]);
  }
}

}  // namespace panicle
