#include "mesh/subdivision.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace panicle {
namespace {

// Of a vertex with n edges: the mean of its faces' points, twice that of its edges' middles, n − 3 times itself.
glm::vec3 rounded(const glm::vec3& place, const glm::vec3& faces, const glm::vec3& middles, std::uint32_t valence) {
  if (valence == 0) return faces;
  const auto n = static_cast<float>(valence);
  return (faces / n + 2.0f * middles / n + (n - 3) * place) / n;
}

}  // namespace

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

  std::vector<std::uint32_t> before(halves), edge(halves);
  std::uint32_t edges = 0;
  for (std::uint32_t h = 0; h < halves; ++h) {
    before[surface.next[h]] = h;
    const std::uint32_t twin = surface.twin[h];
    edge[h] = h < twin ? edges++ : edge[twin];
  }
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
    of_vertex[v] = rounded(surface.positions[v], of_vertex[v], middles[v], valence[v]);
}

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
    about[v] = rounded(surface.positions[v], about[v], middles[v], valence[v]);
  return about;
}

ClosedSurface subdivided(const ClosedSurface& surface) {
  ClosedSurface fine = refined(surface);
  place_refined(surface, fine);
  return fine;
}

std::vector<glm::vec3> normals_of(const ClosedSurface& surface) {
  std::vector<glm::vec3> normals(surface.positions.size(), glm::vec3(0));
  // The corner's own triangle: the bend of a quad is shared out among its corners.
  for (std::uint32_t h = 0; h < surface.half_edges(); ++h) {
    const std::uint32_t after = surface.next[h], behind = surface.next[after];
    const glm::vec3& corner = surface.positions[surface.origin[after]];
    normals[surface.origin[after]] +=
        glm::cross(surface.positions[surface.origin[behind]] - corner, surface.positions[surface.origin[h]] - corner);
  }
  for (glm::vec3& normal : normals) {
    const float length = std::sqrt(glm::dot(normal, normal));
    normal = length > 1e-20f ? normal / length : glm::vec3(0, 0, 1);
  }
  return normals;
}

}  // namespace panicle
