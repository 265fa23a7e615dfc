#include "foliage/flat_leaf.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "foundation/mathematics.hpp"

namespace panicle {
namespace {

constexpr float farthest = 4;  // a flat leaf reaches no farther, in midribs

// Sets normals: the area-weighted mean of the triangles'.
void shade(Mesh& mesh, std::span<const glm::vec3> places) {
  mesh.normals.assign(mesh.positions.size(), 0);
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const std::uint32_t* corner = &mesh.indices[t];
    const glm::vec3 a = places[corner[0]];
    const glm::vec3 face = glm::cross(places[corner[1]] - a, places[corner[2]] - a);
    for (int k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis) mesh.normals[3 * corner[k] + axis] += face[axis];
    }
  }
  for (std::size_t i = 0; i < mesh.normals.size(); i += 3) {
    float* normal = &mesh.normals[i];
    const float length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (length > 0)
      for (int axis = 0; axis < 3; ++axis) normal[axis] /= length;
    else
      normal[2] = 1;  // of no triangle with an area
  }
}

}  // namespace

Diagnostic check(const FlatLeaf& leaf) {
  const auto refused = [](const char* why) { return Diagnostic{Reason::bad_request, why, 0, 0}; };
  const std::size_t points = leaf.points.size() / 2;
  if (leaf.points.size() % 2 != 0 || leaf.between.size() != points || leaf.uvs.size() != 2 * points ||
      leaf.triangles.size() % 3 != 0 || (!leaf.petiole.empty() && leaf.petiole.size() != 2))
    return refused("The request's leaf has blocks of different lengths.");
  const auto within = [](std::span<const float> values, float low, float high) {
    return std::all_of(values.begin(), values.end(), [&](float value) { return value >= low && value <= high; });
  };
  if (!within(leaf.points, -farthest, farthest) || !within(leaf.between, 0, 1) || !within(leaf.uvs, 0, 1) ||
      !within(leaf.petiole, 0, farthest))
    return refused("The request's leaf has points that no leaf has.");
  if (std::any_of(leaf.triangles.begin(), leaf.triangles.end(), [&](std::uint32_t i) { return i >= points; }))
    return refused("The request's leaf has triangles of points that it has not.");
  return {};
}

void bend(float& along, float& height, float radians) {
  const float angle = along * radians;
  const float radius = 1 / radians + height;
  along = radius * sine(angle);
  height = radius * cosine(angle) - 1 / radians;
}

Mesh raised(const FlatLeaf& leaf, std::span<const glm::vec3> places, bool mirrored) {
  Mesh mesh;
  mesh.positions.reserve(3 * places.size());
  for (const glm::vec3& place : places) mesh.positions.insert(mesh.positions.end(), {place.x, place.y, place.z});
  mesh.uvs.assign(leaf.uvs.begin(), leaf.uvs.end());
  mesh.indices.assign(leaf.triangles.begin(), leaf.triangles.end());
  if (mirrored)
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) std::swap(mesh.indices[t + 1], mesh.indices[t + 2]);
  shade(mesh, places);
  return mesh;
}

}  // namespace panicle
