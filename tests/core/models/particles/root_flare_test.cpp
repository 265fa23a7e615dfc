// The root flare: the foot of trunks on the ground, and of roots under their stems.
#include "stems/root_flare.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "models/particles/space_growing.hpp"

namespace panicle::particles {
namespace {

struct Stand {
  float lowest = 1e9f, widest = 0, narrowest = 1e9f;
};

// Width of a tree's wood on the ground, out from the foot.
Stand stand_of(const Plant& plant) {
  Stand stand;
  const std::vector<float>& at = plant.meshes[0].mesh.positions;
  const std::vector<float>& normals = plant.meshes[0].mesh.normals;
  for (std::size_t v = 0; v + 2 < at.size(); v += 3) {
    stand.lowest = std::min(stand.lowest, at[v + 1]);
    if (at[v + 1] > 1e-3f || normals[v + 1] < -0.9f) continue;
    const float out = std::hypot(at[v], at[v + 2]);
    stand.widest = std::max(stand.widest, out);
    if (out > 0.05f) stand.narrowest = std::min(stand.narrowest, out);
  }
  return stand;
}

TEST_CASE("a swaying trunk is level on the ground, and widens there in ridges") {
  const auto stand = [](float flare, float sway) {
    return stand_of(grow_tree(
        {.parameters = {{"particles", 400}, {"sway", sway}, {"girth", 40}, {"flare", flare}}, .outputs = "meshes"}));
  };
  CHECK(stand(0, 0.3f).lowest == 0);
  CHECK(stand(1, 0.3f).lowest == 0);
  const Stand plain = stand(0, 0), wide = stand(1, 0);
  CHECK(plain.widest < 0.25f);
  CHECK(wide.widest > 0.33f);
  CHECK(wide.widest < 0.45f);
  CHECK(wide.widest > 1.2f * wide.narrowest);
}

TEST_CASE("each of several trunks has its foot") {
  const Plant plant =
      grow_tree({.parameters = {{"particles", 400}, {"stems", 2}, {"width", 4}, {"girth", 20}, {"flare", 1}},
                 .outputs = "meshes"});
  const std::vector<float>& at = plant.meshes[0].mesh.positions;
  for (const float x : {-1.0f, 1.0f}) {
    float widest = 0;
    for (std::size_t v = 0; v + 2 < at.size(); v += 3)
      if (at[v + 1] < 1e-3f && std::fabs(at[v] - x) < 0.5f) widest = std::max(widest, std::hypot(at[v] - x, at[v + 2]));
    CHECK(widest > 0.15f);
  }
}

TEST_CASE("a root flare's normals look out, and its triangles are the only ones below ground level") {
  const Plant plant =
      grow_tree({.parameters = {{"particles", 200}, {"girth", 40}, {"flare", 1.5f}}, .outputs = "meshes"});
  const Mesh& mesh = plant.meshes[0].mesh;
  const auto vector = [](const std::vector<float>& values, std::uint32_t i) {
    return glm::vec3(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
  };
  std::uint32_t down = 0;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const std::uint32_t a = mesh.indices[t], b = mesh.indices[t + 1], c = mesh.indices[t + 2];
    const glm::vec3 pa = vector(mesh.positions, a), pb = vector(mesh.positions, b), pc = vector(mesh.positions, c);
    if (std::max({pa.y, pb.y, pc.y}) > 0.4f) continue;
    const glm::vec3 face = glm::cross(pb - pa, pc - pa);
    if (glm::length(face) < 1e-9f) continue;
    down += glm::normalize(face).y < -0.99f;
    if (pa.y > 0 || pb.y > 0 || pc.y > 0) CHECK(glm::dot(face, vector(mesh.normals, a)) > -1e-6f);
  }
  CHECK(down >= 36);
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

TEST_CASE("the foot of each target is the thickest segment that begins there") {
  const std::vector<Segment> segments{{-1, 0, {0, 0, 0}, {0, 1, 0}, 0.1f, 0.1f},
                                      {-1, 0, {0, 0, 0}, {1, 1, 0}, 0.2f, 0.1f},
                                      {-1, 0, {5, 3, 0}, {5, 4, 0}, 0.3f, 0.1f},
                                      {1, 0, {1, 1, 0}, {2, 2, 0}, 0.4f, 0.1f}};
  const std::vector<glm::vec3> targets{{0, 0, 0}, {9, 0, 0}};
  CHECK(trunk_bases(segments, targets) == std::vector<std::int32_t>{1, -1});
  // A trunk's line: upright first, then from place to place.
  const std::vector<std::int32_t> axes{0, 1, 2, 1};
  const TrunkLine line{segments, axes, 1};
  CHECK(line.at(0.05f) == glm::vec3(0, 0.05f, 0));
  CHECK(line.at(1).x == doctest::Approx(1));
  CHECK(line.at(1.5f).x == doctest::Approx(1.5f));
}

}  // namespace
}  // namespace panicle::particles
