// The feet of trees and roots.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/vectors.hpp"
#include "models/particles/space_growing.hpp"

namespace panicle::particles {
namespace {

TEST_CASE("each of several trunks has its foot") {
  const Plant plant =
      grow_tree({.parameters = {{"particles", 400}, {"stems", 2}, {"width", 4}, {"girth", 20}, {"flare", 1}},
                 .outputs = "meshes"});
  for (const float x : {-1.0f, 1.0f}) {
    float widest = 0;
    for (const glm::vec3& at : vectors_of(plant.meshes[0].mesh.positions))
      if (std::fabs(at.y) < 1e-3f && std::fabs(at.x - x) < 0.5f) widest = std::max(widest, std::hypot(at.x - x, at.z));
    CHECK(widest > 0.13f);
  }
}

TEST_CASE("a root hangs from a stem of the given height that is cut level") {
  const auto top = [](float stump) {
    const Plant plant = grow_root({.parameters = {{"particles", 300}, {"stump", stump}}, .outputs = "meshes"});
    float high = -1;
    const std::vector<float>& at = plant.meshes[0].mesh.positions;
    for (std::size_t v = 1; v < at.size(); v += 3) high = std::max(high, at[v]);
    return high;
  };
  CHECK(top(30) > 0.29f);
  CHECK(top(30) < 0.33f);
  CHECK(top(0) < 0.06f);
}

}  // namespace
}  // namespace panicle::particles
