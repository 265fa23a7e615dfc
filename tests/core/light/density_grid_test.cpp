#include "light/density_grid.hpp"

#include <doctest/doctest.h>

#include <limits>

namespace panicle {
namespace {

const std::vector<LightDirection> above{{{0, 1, 0}, 1}};

TEST_CASE("a box that is not finite, or too long, has one cell along that axis") {
  constexpr float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float large = std::numeric_limits<float>::max();
  for (const float far : {infinity, nan, large, -infinity})
    for (const float edge : {1.0f, infinity, nan, 0.0f, 1e-30f}) {
      DensityGrid cells({-far, 0, 0}, {far, 2, 2}, edge);
      cells.put({0, 0, 0}, 1);
      cells.put({nan, infinity, -infinity}, 1);
      cells.put({large, -large, 1}, 1);
      // Few cells: as many as two metres have of the edge, and one along x.
      if (edge == 1) CHECK(cells.cells() == 9);
      CHECK(cells.cells() <= 3 * 3);
      cells.light(above);
    }
}

TEST_CASE("matter outside the box is added to the nearest cell") {
  const auto dark = [](const glm::vec3& place) {
    DensityGrid cells({0, 0, 0}, {3, 3, 3}, 1);
    cells.put(place, 5);
    return cells.light(above);
  };
  const VoxelLight inside = dark({0.5f, 3.5f, 0.5f}), beside = dark({-7, 9, -0.5f});
  for (const glm::vec3& p : {glm::vec3(0.5f, 0.5f, 0.5f), glm::vec3(2.5f, 0.5f, 0.5f), glm::vec3(0.5f, 2.5f, 2.5f)})
    CHECK(inside.at(p) == beside.at(p));
  CHECK(inside.at({0.5f, 0.5f, 0.5f}) < inside.at({2.5f, 0.5f, 2.5f}));
}

}  // namespace
}  // namespace panicle
