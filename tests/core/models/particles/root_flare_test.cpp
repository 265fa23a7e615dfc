// The root flare: the foot of trunks on the ground, and of roots under their stems.
#include "stems/root_flare.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "foundation/mathematics.hpp"
#include "foundation/vectors.hpp"
#include "mesh/normals.hpp"
#include "models/particles/space_growing.hpp"
#include "stems/wood.hpp"

namespace panicle::particles {
namespace {

// The positions of a tree's wood.
std::vector<glm::vec3> wood_of(const Plant& plant) { return vectors_of(plant.meshes[0].mesh.positions); }

// The width of a tree's wood at a height, in the mean over directions; `reach`: how far from the trunk's middle it may
// be.
float width_at(const std::vector<glm::vec3>& wood, float height, float tolerance, float reach) {
  constexpr int directions = 12;
  float sum = 0;
  for (int i = 0; i < directions; ++i) {
    const SinCos way = sincos_degrees(180.0f * static_cast<float>(i) / directions);
    float low = 1e9f, high = -1e9f;
    for (const glm::vec3& at : wood) {
      if (std::fabs(at.y - height) > tolerance || std::hypot(at.x, at.z) > reach) continue;
      const float along = at.x * way.cosine + at.z * way.sine;
      low = std::min(low, along);
      high = std::max(high, along);
    }
    sum += high - low;
  }
  return sum / directions;
}

Plant tree_with(float flare, float sway = 0) {
  return grow_tree(
      {.parameters = {{"particles", 400}, {"sway", sway}, {"girth", 60}, {"flare", flare}}, .outputs = "meshes"});
}

TEST_CASE("a trunk is 1.5 to 1.9 times as wide at the ground as above, for flares of trees") {
  for (const float flare : {0.15f, 0.3f, 0.5f}) {
    CAPTURE(flare);
    const Plant plant = tree_with(flare);
    const auto wood = wood_of(plant);
    // The base segment's radius is that of the trunk above the flare.
    float thickest = 0;
    for (const Segment& segment : plant.segments) thickest = std::max(thickest, segment.radius);
    const float ratio = width_at(wood, 0, 1e-3f, 5 * thickest) / (2 * thickest);
    CHECK(ratio > 1.5f);
    CHECK(ratio < 1.9f);
  }
}

TEST_CASE("a trunk goes on below the ground as deep as it is thick, 30 cm at most") {
  for (const float flare : {0.0f, 0.5f}) {
    CAPTURE(flare);
    const Plant plant = tree_with(flare, 0.3f);
    float thickest = 0, lowest = 0;
    for (const Segment& segment : plant.segments) thickest = std::max(thickest, segment.radius);
    for (const glm::vec3& at : wood_of(plant)) lowest = std::min(lowest, at.y);
    CHECK(lowest == doctest::Approx(-std::min(thickest, 0.3f)).epsilon(0.02));
  }
}

TEST_CASE("spurs differ in number and direction from seed to seed, four to seven of them") {
  std::set<int> numbers;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const std::vector<Segment> trunk{{-1, 0, {0, 0, 0}, {0, 3, 0}, 0.3f, 0.3f},
                                     {0, 0, {0, 3, 0}, {0, 6, 0}, 0.3f, 0.2f}};
    const std::vector<std::int32_t> axes{0, 0};
    const std::vector<glm::vec3> targets{{0, 0, 0}};
    const StemMesh stems = sweep_wood(trunk, axes, targets, {.flare = 0.5f, .seed = seed});
    std::map<float, float> out;
    for (const glm::vec3& at : vectors_of(stems.mesh.positions))
      if (std::fabs(at.y) < 1e-4f) out[std::atan2(at.z, at.x)] = std::hypot(at.x, at.z);
    std::vector<float> radii;
    for (const auto& [angle, radius] : out) radii.push_back(radius);
    REQUIRE(radii.size() >= 24);
    int spurs = 0;
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const float before = radii[(i + radii.size() - 1) % radii.size()], after = radii[(i + 1) % radii.size()];
      spurs += radii[i] >= before && radii[i] > after;
    }
    CHECK(spurs >= 3);  // two may have grown into one
    CHECK(spurs <= 7);
    numbers.insert(spurs);
  }
  CHECK(numbers.size() >= 3);
}

TEST_CASE("each of several trunks has its foot") {
  const Plant plant =
      grow_tree({.parameters = {{"particles", 400}, {"stems", 2}, {"width", 4}, {"girth", 20}, {"flare", 1}},
                 .outputs = "meshes"});
  for (const float x : {-1.0f, 1.0f}) {
    float widest = 0;
    for (const glm::vec3& at : wood_of(plant))
      if (std::fabs(at.y) < 1e-3f && std::fabs(at.x - x) < 0.5f) widest = std::max(widest, std::hypot(at.x - x, at.z));
    CHECK(widest > 0.13f);
  }
}

TEST_CASE("a root flare's normals look out, and it continues the trunk without a step") {
  const std::vector<Segment> trunk{{-1, 0, {0, 0, 0}, {0.1f, 3, 0}, 0.3f, 0.28f},
                                   {0, 0, {0.1f, 3, 0}, {0, 6, 0}, 0.28f, 0.2f}};
  const std::vector<std::int32_t> axes{0, 0};
  const std::vector<glm::vec3> targets{{0, 0, 0}};
  const StemMesh stems = sweep_wood(trunk, axes, targets, {.flare = 0.5f});
  const Mesh& mesh = stems.mesh;
  std::size_t triangles = 0;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const std::uint32_t* corners = &mesh.indices[t];
    const glm::vec3 face = triangle_normal(vector_at(mesh.positions, corners[0]), vector_at(mesh.positions, corners[1]),
                                           vector_at(mesh.positions, corners[2]));
    glm::vec3 mean(0);
    float highest = -1;
    for (int k = 0; k < 3; ++k) {
      mean += vector_at(mesh.normals, corners[k]);
      highest = std::max(highest, mesh.positions[3 * corners[k] + 1]);
    }
    if (highest > 0.9f) continue;
    ++triangles;
    CHECK(glm::dot(face, mean) > 0);
  }
  CHECK(triangles > 500);
  // Where the flare begins, each of its vertices is on an edge of the tube's polygon, and has the same bark.
  const auto positions = vectors_of(mesh.positions);
  const std::size_t flare = stems.parts.back().first_vertex + stems.parts.back().vertex_count;
  for (std::size_t v = flare; v < flare + 36; v += 3) {
    bool found = false;
    for (std::size_t other = 0; other < flare && !found; ++other)
      found = glm::distance(positions[v], positions[other]) < 1e-4f &&
              std::fabs(mesh.uvs[2 * v] - mesh.uvs[2 * other]) < 1e-3f &&
              std::fabs(mesh.uvs[2 * v + 1] - mesh.uvs[2 * other + 1]) < 1e-3f;
    CHECK(found);
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

TEST_CASE("the foot of each target is the thickest segment that begins there") {
  const std::vector<Segment> segments{{-1, 0, {0, 0, 0}, {0, 1, 0}, 0.1f, 0.1f},
                                      {-1, 0, {0, 0, 0}, {1, 1, 0}, 0.2f, 0.1f},
                                      {-1, 0, {5, 3, 0}, {5, 4, 0}, 0.3f, 0.1f},
                                      {1, 0, {1, 1, 0}, {2, 2, 0}, 0.4f, 0.1f}};
  const std::vector<glm::vec3> targets{{0, 0, 0}, {9, 0, 0}};
  CHECK(trunk_bases(segments, targets) == std::vector<std::int32_t>{1, -1});
}

}  // namespace
}  // namespace panicle::particles
