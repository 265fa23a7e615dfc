// The form of a bunch and of its berries.
#include "models/bunch/measures/measures_form.hpp"

#include <doctest/doctest.h>

#include "models/bunch/measures/balls.hpp"

using namespace panicle;
using namespace panicle::bunch;
using enum Measure;

TEST_CASE("bunches of known shape") {
  const auto shaped = [](auto half_width) {
    const auto inside = [&](const glm::vec3& p) {
      const float w = half_width(-p.y / 200);
      return p.y > -200 && p.x * p.x + p.z * p.z <= w * w;
    };
    return Measured(balls(lattice(8, inside), 4), {});
  };
  const Measured cylinder = shaped([](float) { return 40.0f; });
  const Measured cone = shaped([](float t) { return 60 - 50 * t; });
  const Measured funnel = shaped([](float t) { return t < 0.3f ? 70.0f : 25.0f; });
  CHECK(cylinder[bunch_shape] == 1);
  CHECK(cone[bunch_shape] == 2);
  CHECK(funnel[bunch_shape] == 3);
  CHECK(cylinder[wings] == 0);
  CHECK(cone[wings] == 0);
  CHECK(funnel[wings] == 4);
  std::vector<glm::vec3> winged =
      lattice(8, [](const glm::vec3& p) { return p.y > -200 && p.x * p.x + p.z * p.z <= 900; });
  for (int k = 0; k < 10; ++k) winged.push_back({-30 - 8 * k, -20, 0});
  CHECK(Measured(balls(winged, 4), {})[wings] == 1);
}

TEST_CASE("berries are named after their form") {
  CHECK(berry_shape_note({}, 0.9f) == 1);
  CHECK(berry_shape_note({}, 1) == 2);
  CHECK(berry_shape_note({}, 1.2f) == 3);
  CHECK(berry_shape_note({}, 1.7f) == 4);
  CHECK(berry_shape_note({0, 0.8f}, 1.5f) == 5);
  CHECK(berry_shape_note({-0.5f, 0.6f}, 1.3f) == 6);
  CHECK(berry_shape_note({-0.5f, 0}, 1.3f) == 7);
  CHECK(berry_shape_note({0.5f, 0}, 1.3f) == 8);
  CHECK(berry_shape_note({0, 0.8f}, 3) == 10);
  const auto bent = [](float curve) { return BerryForm{-0.2f, 0, Fruit::grape, curve}; };
  CHECK(berry_shape_note(bent(0.9f), 2.4f) == 9);
  CHECK(berry_shape_note(bent(0.3f), 2.4f) == 10);
  CHECK(uniformity_note(0.07f) == 2);
  CHECK(uniformity_note(0.3f) == 1);
}

TEST_CASE("the peduncle ends where the bunch first branches") {
  GrownBunch grown;
  const auto add = [&](std::int32_t parent, float from, float to) {
    grown.internodes.push_back({{parent, 0, {0, from, 0}, {0, to, 0}, 0.001f, 0.001f}, Kind::rachis});
  };
  add(-1, 0, -0.02f);
  add(0, -0.02f, -0.05f);
  add(1, -0.05f, -0.06f);
  add(1, -0.05f, -0.07f);
  const Measured measured(grown, {});
  CHECK(measured[peduncle_length] == about(50, 1e-4));
  CHECK(measured[berry_count] == 0);
}
