// The ground: its heights are within the relief and equal those of its mesh; it is darker under crowns.
#include <algorithm>
#include <cmath>

#include "models/stand/plans.hpp"

using namespace panicle;
using namespace panicle::stand;
using namespace panicle::stand::tests;

TEST_CASE("stand: the ground is within its relief, and its normals match its slope") {
  Ground ground;
  ground.relief = 3;
  const Relief relief(ground, 5);
  const Mesh mesh = relief.mesh();
  float low = 9, high = -9;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    const float* const at = &mesh.positions[i];
    low = std::min(low, at[1]);
    high = std::max(high, at[1]);
    CHECK(at[1] == relief.at(at[0], at[2]));
    const float slope = (relief.at(at[0] + 0.01f, at[2]) - relief.at(at[0] - 0.01f, at[2])) / 0.02f;
    CHECK(-mesh.normals[i] / mesh.normals[i + 1] == doctest::Approx(slope).epsilon(0.05).scale(1));
  }
  CHECK(high - low <= 3);
  CHECK(high - low > 1);
  for (const std::uint32_t index : mesh.indices) CHECK(3 * index + 2 < mesh.positions.size());
}

TEST_CASE("stand: the ground is dark below a crown and light away from it") {
  const Plan plan = sound(read_plan("plants 1, random\na/b, crown 4 x 8"));
  const auto sky = sky_below(plan, std::vector<Placement>(1), {0, 0, 0, 3, 0, 0, 12, 0, 0});
  CHECK(sky[0] < 130);
  CHECK(sky[1] > sky[0]);
  CHECK(sky[1] < 255);
  CHECK(sky[2] == 255);
}
