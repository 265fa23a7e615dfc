#include "models/bunch/natural/natural_plan.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "foundation/mathematics.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

NaturalPlan plan_for(const Profile& profile, Parameter key = Parameter::unit, float value = 0.25f) {
  Request request = natural_request(profile);
  set(request, key, value);
  std::vector<std::string> notes;
  return make_natural_plan(profile, Values(request.parameters, notes), 3000);
}

constexpr float pixel = 0.25f * 50 / 29;

}  // namespace

TEST_CASE("the outline is a quarter ellipse, a line, and straight to a rounded tip") {
  const Envelope drum(Profile{400, {{{100, 100}, {60, 50}, {100, 100}, {100, 100}}}}, 1, 30);
  CHECK(drum.half_width(0, 0) == 0);
  CHECK(drum.half_width(0, 100) == doctest::Approx(100));
  CHECK(drum.half_width(0, 50) == doctest::Approx(100 * std::sqrt(0.75)));
  CHECK(drum.half_width(1, 50) == doctest::Approx(60));
  // rd = 100 × 0.056, one axis each 29 pixels from the first on; the right side is side 0.
  CHECK(drum.half_width(0, 29 * (5.6f + 1)) == doctest::Approx(30));
  CHECK(drum.half_width(0, 300) == doctest::Approx(30));
  CHECK(drum.half_width(0, 400) == doctest::Approx(0));
  CHECK(drum.half_width(0, 401) == 0);
  CHECK(drum.half_width(0, -1) == 0);
  const Envelope thin(Profile{400, {{{9, 20}, {9, 20}, {9, 20}, {9, 20}}}}, 1, 30);
  CHECK(thin.half_width(0, 200) == 9);
}

TEST_CASE("area and volume are those of the slices") {
  const Envelope drum(Profile{400, {{{100, 0}, {100, 0}, {50, 0}, {50, 0}}}}, 1, 500);
  // Straight sides but for the rounded tip, a quarter ellipse of height min(narrow, l / 2).
  CHECK(drum.area(0) == doctest::Approx(2 * (100 * 300 + 3.14159 / 4 * 100 * 100)).epsilon(0.01));
  CHECK(drum.volume() < 3.14160 * 100 * 50 * 400);
  CHECK(drum.volume() > 0.8 * 3.14159 * 100 * 50 * 400);
}

TEST_CASE("axes bring their berries to the outline, and none is longer than that") {
  for (const Table3Row& row : table3) {
    const NaturalPlan plan = plan_for(row.profile());
    REQUIRE(plan.arm.size() == plan.aim.size());
    for (std::size_t k = 0; k < plan.arm.size(); ++k) {
      if (plan.arm[k] < 0) {
        CHECK(row.profile().sides[k % 4].width < 12.5f);
        continue;
      }
      if (plan.length - static_cast<float>(k + 1) * plan.spacing < 0.4f * plan.length) break;  // nodes draw together
      const float depth = static_cast<float>(k + 1) * plan.spacing;
      const SinCos way = sincos_degrees(plan.aim[k]);
      const float reach = plan.arm[k] + plan.twig + plan.stalk + 0.75f * 18 * 1.04f;
      if (plan.arm[k] > 0.4f * plan.step + 0.01f)
        CHECK(plan.envelope.half_width(k % 4, depth + reach * way.cosine) ==
              doctest::Approx(reach * way.sine).epsilon(0.02));
      CHECK(plan.aim[k] <= 100);
      CHECK(plan.aim[k] > 0);
    }
  }
}

TEST_CASE("lengths and angles change smoothly with every pixel") {
  for (const Table3Row& row : table3) {
    Profile profile = row.profile();
    const NaturalPlan before = plan_for(profile);
    profile.length += 1;
    profile.sides[0].width += 1;
    profile.sides[2].drop += 1;
    const NaturalPlan after = plan_for(profile);
    CHECK(std::abs(after.length - before.length) < 1.2f * pixel);
    CHECK(std::abs(after.spacing - before.spacing) < 0.1f * pixel);
    for (std::size_t k = 0; k < std::min(before.arm.size(), after.arm.size()); ++k)
      CHECK(std::abs(after.arm[k] - before.arm[k]) < 8 * pixel);
  }
}

TEST_CASE("more berries are asked for where density is higher, berries smaller or a count given") {
  const Profile profile = table3[2].profile();
  CHECK(plan_for(profile, Parameter::density, 9).berries > plan_for(profile, Parameter::density, 3).berries);
  CHECK(plan_for(profile, Parameter::size, 12).berries > 2 * plan_for(profile, Parameter::size, 18).berries);
  CHECK(plan_for(profile, Parameter::count, 77).berries == 77);
  CHECK(plan_for(profile, Parameter::count, 600).spacing < plan_for(profile, Parameter::count, 100).spacing);
  for (float density = 1; density < 9; density += 0.25f) CHECK(fill_of(density + 0.25f) > fill_of(density));
}

TEST_CASE("the plan lays nodes as the text's constants say, and gives as many lengths as a text can ask for") {
  const Profile profile = table3[2].profile();
  Request request = natural_request(profile);
  std::vector<std::string> notes;
  const Values values(request.parameters, notes);
  const auto nodes = [&](const TextConstants& text) {
    return make_natural_plan(profile, values, 3000, text).arm.size();
  };
  TextConstants near, even, steep;
  near.tip_spacing = 0.2f;
  even.tip_spacing = 1;
  steep.yaw = 25;
  CHECK(nodes(near) > nodes({}) + 2);
  CHECK(nodes(even) < nodes({}));
  CHECK(make_natural_plan(profile, values, 3000, steep).aim[8] < make_natural_plan(profile, values, 3000).aim[8] - 10);
  TextConstants endless;
  endless.tip_spacing = 0;
  CHECK(nodes(endless) <= 4096);
  const NaturalPlan plan = make_natural_plan(profile, values, 3000);
  for (const lsystem::Inputs::Array& array : inputs_for(plan, profile, values).arrays)
    if (array.name == "aim" || array.name == "arm") {
      REQUIRE(array.values.size() == 4096);
      CHECK(array.values[4095] == array.values[4091]);
      CHECK(array.values[plan.aim.size()] == array.values[plan.aim.size() - 4]);
    }
}
