#include "mesh/subdivision.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/normals.hpp"

namespace panicle {
namespace {

// The new place of a vertex by Catmull & Clark (1978): (F + 2 M + (n − 3) P) / n, with F the mean of its n faces'
// points, M that of its edges' middles, and P itself. `faces` and `middles` are sums.
glm::vec3 catmull_clark_vertex(const glm::vec3& place, const glm::vec3& faces, const glm::vec3& middles,
                               std::uint32_t valence) {
  if (valence == 0) return faces;
  const auto n = static_cast<float>(valence);
  return (faces / n + 2.0f * middles / n + (n - 3) * place) / n;
}

}  // namespace

// The topology of the Catmull-Clark subdivision of a surface: each half-edge becomes a quad between its origin, the
// middle of its edge, the face's point and the middle of the edge before.
ClosedSurface refined(const ClosedSurface& surface) {
  const std::uint32_t halves = surface.half_edges();
  const auto vertices = static_cast<std::uint32_t>(surface.positions.size());
  ClosedSurface fine;
  fine.faces = halves;
  fine.origin.resize(4 * halves);
  fine.next.resize(4 * halves);
  fine.twin.resize(4 * halves);
  fine.face.resize(4 * halves);
  fine.positions.resize(vertices + halves / 2 + surface.faces);

  // The half-edge before each in its face, and the number of each one's edge.
  std::vector<std::uint32_t> before(halves), edge(halves);
  std::uint32_t edges = 0;
  for (std::uint32_t h = 0; h < halves; ++h) {
    before[surface.next[h]] = h;
    const std::uint32_t twin = surface.twin[h];
    edge[h] = h < twin ? edges++ : edge[twin];
  }
  // Half-edge h becomes the quad with the half-edges 4 h … 4 h + 3.
  for (std::uint32_t h = 0; h < halves; ++h) {
    const std::uint32_t first = 4 * h, last = before[h];
    fine.origin[first] = surface.origin[h];
    fine.origin[first + 1] = vertices + edge[h];
    fine.origin[first + 2] = vertices + edges + surface.face[h];
    fine.origin[first + 3] = vertices + edge[last];
    fine.twin[first] = 4 * surface.next[surface.twin[h]] + 3;
    fine.twin[first + 1] = 4 * surface.next[h] + 2;
    fine.twin[first + 2] = 4 * last + 1;
    fine.twin[first + 3] = 4 * surface.twin[last];
    for (std::uint32_t i = 0; i < 4; ++i) {
      fine.next[first + i] = first + (i + 1) % 4;
      fine.face[first + i] = h;
    }
  }
  return fine;
}

// Places the vertices of a refined surface by the rules of Catmull & Clark. Vertices come first, then edges' points,
// then faces' points.
void place_refined(const ClosedSurface& surface, ClosedSurface& fine) {
  const std::uint32_t halves = surface.half_edges();
  const auto vertices = static_cast<std::uint32_t>(surface.positions.size());
  std::fill(fine.positions.begin(), fine.positions.end(), glm::vec3(0));
  glm::vec3* const of_vertex = fine.positions.data();
  glm::vec3* const of_edge = of_vertex + vertices;
  glm::vec3* const of_face = of_edge + halves / 2;

  std::vector<std::uint32_t> degree(surface.faces, 0);
  for (std::uint32_t h = 0; h < halves; ++h) {
    of_face[surface.face[h]] += surface.positions[surface.origin[h]];
    ++degree[surface.face[h]];
  }
  for (std::uint32_t f = 0; f < surface.faces; ++f) of_face[f] /= static_cast<float>(degree[f]);

  std::vector<glm::vec3> middles(vertices, glm::vec3(0));
  std::vector<std::uint32_t> valence(vertices, 0);
  for (std::uint32_t h = 0; h < halves; ++h) {
    const std::uint32_t from = surface.origin[h], twin = surface.twin[h], to = surface.origin[twin];
    const glm::vec3 middle = 0.5f * (surface.positions[from] + surface.positions[to]);
    if (h < twin) {
      const std::uint32_t edge = fine.origin[4 * h + 1] - vertices;
      of_edge[edge] = 0.25f * (2.0f * middle + of_face[surface.face[h]] + of_face[surface.face[twin]]);
    }
    of_vertex[from] += of_face[surface.face[h]];
    middles[from] += middle;
    ++valence[from];
  }
  for (std::uint32_t v = 0; v < vertices; ++v)
    of_vertex[v] = catmull_clark_vertex(surface.positions[v], of_vertex[v], middles[v], valence[v]);
}

// The places of a surface's own vertices after one round of subdivision.
std::vector<glm::vec3> rounded_vertices(const ClosedSurface& surface) {
  const auto vertices = static_cast<std::uint32_t>(surface.positions.size());
  const std::uint32_t halves = surface.half_edges();
  std::vector<glm::vec3> of_face(surface.faces, glm::vec3(0)), about(vertices, glm::vec3(0)), middles(about);
  std::vector<std::uint32_t> degree(surface.faces, 0), valence(vertices, 0);
  for (std::uint32_t h = 0; h < halves; ++h) {
    of_face[surface.face[h]] += surface.positions[surface.origin[h]];
    ++degree[surface.face[h]];
  }
  for (std::uint32_t f = 0; f < surface.faces; ++f) of_face[f] /= static_cast<float>(degree[f]);
  for (std::uint32_t h = 0; h < halves; ++h) {
    const std::uint32_t from = surface.origin[h];
    about[from] += of_face[surface.face[h]];
    middles[from] += 0.5f * (surface.positions[from] + surface.positions[surface.origin[surface.twin[h]]]);
    ++valence[from];
  }
  for (std::uint32_t v = 0; v < vertices; ++v)
    about[v] = catmull_clark_vertex(surface.positions[v], about[v], middles[v], valence[v]);
  return about;
}

// One round of Catmull-Clark subdivision.
ClosedSurface subdivided(const ClosedSurface& surface) {
  ClosedSurface fine = refined(surface);
  place_refined(surface, fine);
  return fine;
}

// The unit normals of all vertices.
std::vector<glm::vec3> normals_of(const ClosedSurface& surface) {
  std::vector<glm::vec3> normals(surface.positions.size(), glm::vec3(0));
  // The corner's own triangle: the bend of a quad is shared out among its corners.
  for (std::uint32_t h = 0; h < surface.half_edges(); ++h) {
    const std::uint32_t after = surface.next[h], behind = surface.next[after];
    const glm::vec3& corner = surface.positions[surface.origin[after]];
    normals[surface.origin[after]] +=
        triangle_normal(corner, surface.positions[surface.origin[behind]], surface.positions[surface.origin[h]]);
  }
  for (glm::vec3& normal : normals) normal = unit_normal(normal, 1e-20f);
  return normals;
}

}  // namespace panicle
