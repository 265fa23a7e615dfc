#include "models/grammar/blades.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "mesh/polygon.hpp"
#include "models/grammar/plate.hpp"

namespace panicle::grammar {
namespace {

// Normals of corners: the mean of the adjacent triangles' normals, weighted by area, so that a bent blade is smooth.
std::vector<glm::vec3> normals_of(std::span<const glm::vec3> corners, const std::vector<std::uint32_t>& triangles) {
  std::vector<glm::vec3> sums(corners.size(), glm::vec3(0));
  glm::vec3 whole(0);
  for (std::size_t k = 0; k < triangles.size(); k += 3) {
    const glm::vec3 &a = corners[triangles[k]], &b = corners[triangles[k + 1]], &c = corners[triangles[k + 2]];
    const glm::vec3 twice = glm::cross(b - a, c - a);
    for (std::size_t m = 0; m < 3; ++m) sums[triangles[k + m]] += twice;
    whole += twice;
  }
  const auto unit = [](const glm::vec3& v, const glm::vec3& otherwise) {
    const float size = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    return size > 0 ? glm::normalize(v / size) : otherwise;
  };
  const glm::vec3 mean = unit(whole, {0, 0, 1});
  for (glm::vec3& sum : sums) sum = unit(sum, mean);
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
    blades.runs.push_back({"Blade", base, static_cast<std::uint32_t>(used.size()), first,
                           static_cast<std::uint32_t>(mesh.indices.size()) - first});
    colour.push_back(polygon.mark.colour);
    organ.push_back(polygon.organ);
  }
  blades.columns.add("colour", std::move(colour));
  blades.columns.add("organ", std::move(organ));
  return blades;
}

}  // namespace panicle::grammar
