// The root flare: the foot of trunks on the ground.
#include "stems/root_flare.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <vector>

#include "foundation/mathematics.hpp"
#include "foundation/vectors.hpp"
#include "mesh/normals.hpp"
#include "stems/wood.hpp"

namespace panicle {
namespace {

// The width of a tree's wood at a height, in the mean over directions; `reach`: how far from the trunk's middle it may
// be.
float width_at(const std::vector<glm::vec3>& wood, float height, float tolerance) {
  constexpr int directions = 12;
  float sum = 0;
  for (int i = 0; i < directions; ++i) {
    const SinCos way = sincos_degrees(180.0f * static_cast<float>(i) / directions);
    float low = 1e9f, high = -1e9f;
    for (const glm::vec3& at : wood) {
      if (std::fabs(at.y - height) > tolerance) continue;
      const float along = at.x * way.cosine + at.z * way.sine;
      low = std::min(low, along);
      high = std::max(high, along);
    }
    sum += high - low;
  }
  return sum / directions;
}

// A trunk of two pieces, as wood.
StemMesh trunk_with(float radius, const RootFlareOptions& options) {
  const std::vector<Segment> trunk{{-1, 0, {0, 0, 0}, {0, 3, 0}, radius, radius},
                                   {0, 0, {0, 3, 0}, {0, 6, 0}, radius, 0.7f * radius}};
  const std::vector<std::int32_t> axes{0, 0};
  const std::vector<glm::vec3> targets{{0, 0, 0}};
  return sweep_wood(trunk, axes, targets, options);
}

TEST_CASE("a trunk is 1.5 to 1.9 times as wide at the ground as at 1.3 m, for flares of trees") {
  for (const float flare : {0.15f, 0.3f, 0.5f})
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      CAPTURE(flare);
      const auto wood = vectors_of(trunk_with(0.3f, {.flare = flare, .seed = seed}).mesh.positions);
      const float ratio = width_at(wood, 0, 1e-4f) / (2 * 0.3f);
      CHECK(ratio > 1.45f);
      CHECK(ratio < 1.9f);
      // Above the flare the trunk is as thick as its segments.
      float widest = 0;
      for (const glm::vec3& at : wood)
        if (at.y > 1.26f) widest = std::max(widest, std::hypot(at.x, at.z));
      CHECK(widest < 0.31f);
    }
}

TEST_CASE("a trunk goes on below the ground as deep as it is thick, 30 cm at most") {
  for (const float flare : {0.0f, 0.5f})
    for (const float radius : {0.1f, 0.3f, 0.5f}) {
      CAPTURE(flare);
      CAPTURE(radius);
      float lowest = 0;
      for (const glm::vec3& at : vectors_of(trunk_with(radius, {.flare = flare}).mesh.positions))
        lowest = std::min(lowest, at.y);
      CHECK(lowest == doctest::Approx(-std::min(radius, 0.3f)).epsilon(0.01));
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

TEST_CASE("the foot of each target is the thickest segment that begins there") {
  const std::vector<Segment> segments{{-1, 0, {0, 0, 0}, {0, 1, 0}, 0.1f, 0.1f},
                                      {-1, 0, {0, 0, 0}, {1, 1, 0}, 0.2f, 0.1f},
                                      {-1, 0, {5, 3, 0}, {5, 4, 0}, 0.3f, 0.1f},
                                      {1, 0, {1, 1, 0}, {2, 2, 0}, 0.4f, 0.1f}};
  const std::vector<glm::vec3> targets{{0, 0, 0}, {9, 0, 0}};
  CHECK(trunk_bases(segments, targets) == std::vector<std::int32_t>{1, -1});
}

}  // namespace
}  // namespace panicle
