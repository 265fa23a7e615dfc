#include "foundation/lane_vectors.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

using namespace panicle;

TEST_CASE("unit gives each lane's vector unit length, as for a single vector") {
  const glm::vec3 vectors[] = {{3, 0, 4}, {-1, 2, -2}, {0, 1e-3f, 0}, {1e4f, -1e4f, 0.5f}};
  FourVectors four{};
  for (int lane = 0; lane < 4; ++lane) {
    four.x[lane] = vectors[lane].x;
    four.y[lane] = vectors[lane].y;
    four.z[lane] = vectors[lane].z;
  }
  const FourVectors of = unit(four);
  for (int lane = 0; lane < 4; ++lane)
    CHECK(glm::vec3(of.x[lane], of.y[lane], of.z[lane]) == glm::normalize(vectors[lane]));
}

TEST_CASE("all_of sets every lane") {
  const FourVectors four = all_of(glm::vec3(1, 2, 3));
  for (int lane = 0; lane < 4; ++lane) CHECK(glm::vec3(four.x[lane], four.y[lane], four.z[lane]) == glm::vec3(1, 2, 3));
}
