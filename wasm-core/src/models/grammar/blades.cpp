#include "models/grammar/blades.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "mesh/normals.hpp"
#include "mesh/polygon.hpp"
#include "models/grammar/plate.hpp"

namespace panicle::grammar {
namespace {

// Normals of corners: the mean of the adjacent triangles' normals, weighted by area, so that a bent blade is smooth.
std::vector<glm::vec3> normals_of(std::span<const glm::vec3> corners, const std::vector<std::uint32_t>& triangles) {
  std::vector<glm::vec3> sums =
      sum_normals(corners.size(), triangles, [&](std::uint32_t corner) { return corners[corner]; });
  glm::vec3 whole(0);
  for (std::size_t k = 0; k < triangles.size(); k += 3)
    whole += triangle_normal(corners[triangles[k]], corners[triangles[k + 1]], corners[triangles[k + 2]]);
  const glm::vec3 mean = unit_or(whole, {0, 0, 1});
  for (glm::vec3& sum : sums) sum = unit_or(sum, mean);
  return sums;
}

// Adds texture coordinates of vertices: the polygon's bounding box, seen along its mean normal, is the picture. `used`:
// the corner of each vertex.
void add_uvs(Mesh& mesh, std::span<const glm::vec3> corners, const std::vector<std::uint32_t>& used) {
  glm::vec3 low = corners[used[0]], high = low;
  for (const std::uint32_t corner : used) {
    low = glm::min(low, corners[corner]);
    high = glm::max(high, corners[corner]);
  }
  const glm::vec3 size = high - low;
  int least = 0;
  for (int k = 1; k < 3; ++k)
    if (size[k] < size[least]) least = k;
  const int right = least == 0 ? 1 : 0, up = least == 2 ? 1 : 2;
  for (const std::uint32_t corner : used) {
    const glm::vec3 at = corners[corner] - low;
    put(mesh.uvs, glm::vec2(size[right] > 0 ? at[right] / size[right] : 0, size[up] > 0 ? 1 - at[up] / size[up] : 0));
  }
}

// Adds a sheet without the corners that no triangle has. `used`: the corner of each vertex.
void add_sheet(Mesh& mesh, std::span<const glm::vec3> corners, const std::vector<std::uint32_t>& triangles,
               std::vector<std::uint32_t>& used) {
  const std::vector<glm::vec3> normals = normals_of(corners, triangles);
  std::vector<std::uint32_t> number(corners.size(), 0);
  for (const std::uint32_t corner : triangles) ++number[corner];
  for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
    if (number[corner] == 0) continue;
    number[corner] = static_cast<std::uint32_t>(mesh.positions.size() / 3);
    used.push_back(corner);
    put(mesh.positions, corners[corner]);
    put(mesh.normals, normals[corner]);
  }
  for (const std::uint32_t corner : triangles) mesh.indices.push_back(number[corner]);
}

}  // namespace

// The mesh of all filled polygons, with a run for each; `scale`: metres of the text's unit. `empty` becomes the number
// of polygons without area.
PlantMesh blades_of(const Polygons& polygons, float scale, std::uint32_t& empty, WorkBudget* budget) {
  PlantMesh blades{"blades", "blade", {}, {}, {}};
  Mesh& mesh = blades.mesh;
  std::vector<std::uint8_t> colour;
  std::vector<std::uint32_t> used, organ;
  empty = 0;
  for (const Polygon& polygon : polygons.all) {
    const auto corners = std::span(polygons.corners).subspan(polygon.first, polygon.count);
    const std::vector<std::uint32_t> triangles = fill_polygon(corners, budget);
    if (triangles.empty()) {
      ++empty;
      continue;
    }
    const auto base = static_cast<std::uint32_t>(mesh.positions.size() / 3);
    const auto first = static_cast<std::uint32_t>(mesh.indices.size());
    used.clear();
    if (polygon.thickness > 0)
      add_plate(mesh, corners, triangles, polygon.thickness, used);
    else
      add_sheet(mesh, corners, triangles, used);
    for (std::size_t i = 3 * std::size_t{base}; i < mesh.positions.size(); ++i) mesh.positions[i] *= scale;
    add_uvs(mesh, corners, used);
    blades.runs.push_back({{base, static_cast<std::uint32_t>(used.size()), first,
                            static_cast<std::uint32_t>(mesh.indices.size()) - first},
                           "Blade"});
    colour.push_back(polygon.mark.colour);
    organ.push_back(polygon.organ);
  }
  blades.columns.add("colour", std::move(colour));
  blades.columns.add("organ", std::move(organ));
  return blades;
}

}  // namespace panicle::grammar
