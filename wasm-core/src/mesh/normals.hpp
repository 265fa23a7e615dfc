// Normals of triangles and of meshes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace panicle {

// The normal of a triangle whose corners are counter-clockwise; its length is twice the triangle's area.
inline glm::vec3 triangle_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return glm::cross(b - a, c - a);
}

// Half the length of the cross product.
inline float triangle_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return 0.5f * glm::length(triangle_normal(a, b, c));
}

// For each vertex the sum of its triangles' normals: the mean weighted by area, but for its length. `position(i)`: the
// position of vertex i.
template <class Position>
std::vector<glm::vec3> sum_normals(std::size_t vertices, std::span<const std::uint32_t> indices, Position position) {
  std::vector<glm::vec3> sums(vertices, glm::vec3(0));
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
    const glm::vec3 normal = triangle_normal(position(indices[t]), position(indices[t + 1]), position(indices[t + 2]));
    for (std::size_t k = t; k < t + 3; ++k) sums[indices[k]] += normal;
  }
  return sums;
}

// The sums of a mesh's triangles.
std::vector<glm::vec3> sum_normals(const Mesh& mesh);

// `normal` at unit length; +Z if it is not longer than `least`.
inline glm::vec3 unit_normal(const glm::vec3& normal, float least = 0) {
  const float length = glm::length(normal);
  return length > least ? normal / length : glm::vec3(0, 0, 1);
}

// Sets a mesh's normals: the mean of each vertex's triangles, weighted by area.
void set_normals(Mesh& mesh);

}  // namespace panicle
