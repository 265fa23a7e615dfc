// Posts are between plants, wires run from end to end over the ground, and tied plants have one direction.
#include "models/stand/trellises.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <set>

#include "models/stand/plans.hpp"

using namespace panicle;
using namespace panicle::stand;
using namespace panicle::stand::tests;

namespace {

Trellises built(const PlacedStand& all) { return trellises_of(all.plan, Relief(all.plan.ground, 1), all.plants); }

std::vector<glm::vec3> corners(const Mesh& mesh) {
  std::vector<glm::vec3> all;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3)
    all.emplace_back(mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]);
  return all;
}

}  // namespace

TEST_CASE("stand: a trellis has posts between plants, within the given distance, and at both ends") {
  const PlacedStand all = placed("ground 20 x 8\nplants, rows 4 x 2\ntrellis 2, posts 6\na/b");
  // Two rows more than the middle one; of eleven plants each, in panels of three.
  const Trellises trellises = built(all);
  CHECK(trellises.posts == 3 * 5);
  std::set<int> feet;
  for (const glm::vec3& corner : corners(trellises.wood))
    if (corner.y < 0 && std::abs(corner.x) < 10.5f) feet.insert(static_cast<int>(std::floor(corner.x + 0.5f)));
  CHECK(feet == std::set<int>{-5, 1, 7});
  CHECK(built(placed("ground 20 x 8\nplants, rows 4 x 2\na/b")).posts == 0);
}

TEST_CASE("stand: wires follow the ground at their heights, a pair to both sides of the posts") {
  const PlacedStand all =
      placed("ground 30 x 12, relief 3\nplants, rows 4 x 2, towards 20\ntrellis 2, wire 0.9, pair 1.5\na/b");
  const Relief relief(all.plan.ground, 1);
  const Trellises trellises = built(all);
  for (const Placement& plant : all.plants) {
    std::vector<float> offsets;
    for (const float high : {0.9f, 1.5f}) {
      const float over = relief.at(plant.at.x, plant.at.z) + high;
      const auto met = corners(trellises.metal);
      const auto near = std::count_if(met.begin(), met.end(), [&](const glm::vec3& corner) {
        return glm::distance(corner, glm::vec3(plant.at.x, over, plant.at.z)) < 0.09f;
      });
      // Four corners a ring.
      CHECK(near == (high < 1 ? 4 : 8));
    }
  }
}

TEST_CASE("stand: faces of posts and wires point outwards") {
  const Trellises trellises =
      built(placed("ground 20 x 4\nplants, rows 4 x 2, towards 30\ntrellis 2, wire 0.9, pair 1.5\na/b"));
  for (const Mesh* const mesh : {&trellises.wood, &trellises.metal}) {
    const auto places = corners(*mesh);
    for (std::size_t i = 0; i < mesh->indices.size(); i += 3) {
      const std::uint32_t a = mesh->indices[i], b = mesh->indices[i + 1], c = mesh->indices[i + 2];
      const glm::vec3 normal(mesh->normals[3 * a], mesh->normals[3 * a + 1], mesh->normals[3 * a + 2]);
      CHECK(glm::dot(glm::cross(places[b] - places[a], places[c] - places[a]), normal) > 0);
      CHECK(glm::length(normal) == doctest::Approx(1));
    }
  }
}

TEST_CASE("stand: plants on a trellis have one direction, others two") {
  for (const bool tied : {true, false}) {
    const PlacedStand all =
        placed(std::string("ground 20 x 20\nplants, rows 4 x 2\n") + (tied ? "trellis 2\n" : "") + "a/b");
    const auto back =
        std::count_if(all.plants.begin(), all.plants.end(), [](const Placement& plant) { return plant.turn != 0; });
    CHECK((back == 0) == tied);
  }
}
