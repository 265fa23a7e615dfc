#include "mesh/normals.hpp"

#include <doctest/doctest.h>

using namespace panicle;

namespace {

// A floor of two triangles of area 2 and a wall of one of area 1 that share an edge; the last vertex has no triangle.
Mesh corner_of_room() {
  Mesh mesh;
  for (const glm::vec3& place : {glm::vec3(0, 0, 0), glm::vec3(2, 0, 0), glm::vec3(2, 2, 0), glm::vec3(0, 2, 0),
                                 glm::vec3(1, 0, 1), glm::vec3(9)})
    put(mesh.positions, place);
  put(mesh.indices, 0, 1, 2);
  put(mesh.indices, 0, 2, 3);
  put(mesh.indices, 1, 0, 4);
  return mesh;
}

}  // namespace

TEST_CASE(
    "a triangle's normal is as long as twice its area, towards the side where its corners are counter-clockwise") {
  CHECK(triangle_normal({0, 0, 0}, {2, 0, 0}, {0, 3, 0}) == glm::vec3(0, 0, 6));
  CHECK(triangle_area({0, 0, 0}, {2, 0, 0}, {0, 3, 0}) == 3);
  CHECK(triangle_area({1, 1, 1}, {2, 2, 2}, {3, 3, 3}) == 0);
}

TEST_CASE("set_normals weights a vertex's triangles by their area, and is +Z without any") {
  Mesh mesh = corner_of_room();
  set_normals(mesh);
  const auto normal = [&](std::size_t v) {
    return glm::vec3(mesh.normals[3 * v], mesh.normals[3 * v + 1], mesh.normals[3 * v + 2]);
  };
  REQUIRE(mesh.normals.size() == mesh.positions.size());
  CHECK(glm::distance(normal(0), glm::normalize(glm::vec3(0, 2, 8))) < 1e-6f);
  CHECK(glm::distance(normal(1), glm::normalize(glm::vec3(0, 2, 4))) < 1e-6f);
  CHECK(normal(2) == glm::vec3(0, 0, 1));
  CHECK(normal(4) == glm::vec3(0, 1, 0));
  CHECK(normal(5) == glm::vec3(0, 0, 1));
}

TEST_CASE("sum_normals reads positions through its function") {
  const std::vector<std::uint32_t> indices{0, 1, 2};
  const std::vector<glm::vec3> sums =
      sum_normals(3, indices, [](std::uint32_t vertex) { return glm::vec3(vertex == 1, vertex == 2, 0); });
  for (const glm::vec3& sum : sums) CHECK(sum == glm::vec3(0, 0, 1));
}

TEST_CASE("unit_normal is +Z for a normal that is too short") {
  CHECK(unit_normal({0, 4, 0}) == glm::vec3(0, 1, 0));
  CHECK(unit_normal({0, 0, 0}) == glm::vec3(0, 0, 1));
  CHECK(unit_normal({0, 1e-5f, 0}, 1e-4f) == glm::vec3(0, 0, 1));
}

TEST_CASE("whole_range covers the mesh") {
  const MeshRange range = whole_range(corner_of_room());
  CHECK(range.first_vertex == 0);
  CHECK(range.vertex_count == 6);
  CHECK(range.first_index == 0);
  CHECK(range.index_count == 9);
}
