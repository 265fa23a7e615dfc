#include "foundation/vectors.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace panicle;

TEST_CASE("vectors_of reads all whole vectors") {
  const std::vector<float> values{1, 2, 3, 4, 5, 6, 7, 8};
  CHECK(vectors_of(values) == std::vector<glm::vec3>{{1, 2, 3}, {4, 5, 6}});
  CHECK(vectors_of({}).empty());
  CHECK(vector_at(values, 1) == glm::vec3(4, 5, 6));
}

TEST_CASE("coordinates are finite and up to 10 km") {
  CHECK(are_coordinates({}));
  CHECK(are_coordinates(std::vector<float>{-1e4f, 0, 1e4f}));
  CHECK_FALSE(is_coordinate(-1.001e4f));
  CHECK_FALSE(is_coordinate(std::numeric_limits<float>::infinity()));
  CHECK_FALSE(are_coordinates(std::vector<float>{0, std::numeric_limits<float>::quiet_NaN()}));
}
