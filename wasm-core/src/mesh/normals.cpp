#include "mesh/normals.hpp"

#include "foundation/vectors.hpp"

namespace panicle {

// By vertex, the sum of the normals of its triangles, each as long as twice the triangle's area.
std::vector<glm::vec3> sum_normals(const Mesh& mesh) {
  return sum_normals(mesh.positions.size() / 3, mesh.indices,
                     [&](std::uint32_t vertex) { return vector_at(mesh.positions, vertex); });
}

// Sets smooth normals.
void set_normals(Mesh& mesh) {
  mesh.normals.clear();
  mesh.normals.reserve(mesh.positions.size());
  for (const glm::vec3& sum : sum_normals(mesh)) put(mesh.normals, unit_normal(sum));
}

}  // namespace panicle
