#include "models/bunch/natural/natural_plan.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "foundation/mathematics.hpp"
#include "models/bunch/natural/settling/sagging.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

NaturalPlan plan_for(const Profile& profile, Parameter key = Parameter::unit, float value = 0.25f) {
  BunchRequest request = natural_request(profile);
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
      const Azimuth round = azimuth_of(plan.way[k]);
      if (plan.arm[k] < 0) {
        CHECK(row.profile().sides[round.nearest()].width < 12.5f);
        continue;
      }
      if (plan.length - static_cast<float>(k + 1) * plan.spacing < 0.4f * plan.length) break;  // nodes get closer
      const float depth = static_cast<float>(k + 1) * plan.spacing;
      const SinCos way = sincos_degrees(plan.aim[k]);
      // The axis and a twig go straight on; the pedicel and most of its berry hang.
      const glm::vec3 hangs = drooping({way.sine, -way.cosine, 0}, 1) * (plan.pedicel_length + 0.75f * 18 * 1.04f);
      const float straight = plan.arm[k] + plan.twig;
      if (plan.arm[k] > 0.4f * plan.first_order_spacing + 0.01f)
        CHECK(plan.envelope.radius(round, depth + straight * way.cosine - hangs.y) ==
              doctest::Approx(straight * way.sine + hangs.x).epsilon(0.02));
      CHECK(plan.aim[k] <= 100);
      CHECK(plan.aim[k] > 0);
    }
  }
}

TEST_CASE("axes go round the rachis by the text's turn, nearer to the handles and to the sides that are wide") {
  const auto apart = [](float a, float b) { return std::abs(std::remainder(a - b, 360.0f)); };
  const NaturalPlan even = plan_for(Profile{500, {{{80, 60}, {80, 60}, {80, 60}, {80, 60}}}});
  REQUIRE(even.way.size() == even.arm.size());
  for (std::size_t k = 0; k < even.way.size(); ++k) CHECK(apart(even.way[k], 137.5f * static_cast<float>(k)) < 7.01f);
  const auto near_x = [&](const NaturalPlan& plan) {
    std::ptrdiff_t count = std::count_if(plan.way.begin(), plan.way.end(),
                                         [&](float way) { return apart(way, 0) < 45 || apart(way, 180) < 45; });
    return static_cast<float>(count) / static_cast<float>(plan.way.size());
  };
  const NaturalPlan flat = plan_for(Profile{500, {{{160, 60}, {160, 60}, {40, 60}, {40, 60}}}});
  CHECK(near_x(even) == doctest::Approx(0.5).epsilon(0.1));
  CHECK(near_x(flat) > 0.6f);
}

TEST_CASE("another start turns all axes of an even bunch, and no other length") {
  const Profile profile{500, {{{80, 60}, {80, 60}, {80, 60}, {80, 60}}}};
  const BunchRequest request = natural_request(profile);
  std::vector<std::string> notes;
  const Values values(request.parameters, notes);
  const NaturalPlan plan = make_natural_plan(profile, values, 3000),
                    turned = make_natural_plan(profile, values, 3000, {}, 90);
  CHECK(plan.spacing == turned.spacing);
  REQUIRE(plan.way.size() == turned.way.size());
  for (std::size_t k = 0; k < plan.way.size(); ++k)
    CHECK(std::abs(std::remainder(turned.way[k] - plan.way[k] - 90, 360.0f)) < 0.1f);
}

TEST_CASE("round the bunch the outline is the ellipse of the two sides it lies between") {
  const Envelope envelope(Profile{400, {{{100, 100}, {60, 100}, {50, 100}, {80, 100}}}}, 1, 30);
  // A turtle that hangs rolls from +x (p3) over −z (p6) to −x (p4) and +z (p5).
  CHECK(envelope.radius(azimuth_of(0), 100) == doctest::Approx(100));
  CHECK(envelope.radius(azimuth_of(90), 100) == doctest::Approx(80));
  CHECK(envelope.radius(azimuth_of(180), 100) == doctest::Approx(60));
  CHECK(envelope.radius(azimuth_of(-90), 100) == doctest::Approx(50));
  const float r = envelope.radius(azimuth_of(-45), 100), x = r * std::sqrt(0.5f);
  CHECK(x * x / 10000 + x * x / 2500 == doctest::Approx(1));
  CHECK(envelope.radius(azimuth_of(45), -1) == 0);
  CHECK(azimuth_of(30).between([](std::size_t side) { return side == 0 ? 4.0f : 8.0f; }) == doctest::Approx(5));
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

TEST_CASE("the plan has more berries for a higher density, smaller berries or a given count") {
  const Profile profile = table3[2].profile();
  CHECK(plan_for(profile, Parameter::density, 9).berries > plan_for(profile, Parameter::density, 3).berries);
  CHECK(plan_for(profile, Parameter::size, 12).berries > 2 * plan_for(profile, Parameter::size, 18).berries);
  CHECK(plan_for(profile, Parameter::count, 77).berries == 77);
  CHECK(plan_for(profile, Parameter::count, 600).spacing < plan_for(profile, Parameter::count, 100).spacing);
  for (float density = 1; density < 9; density += 0.25f) CHECK(fill_of(density + 0.25f) > fill_of(density));
}

TEST_CASE("the plan places nodes by the text's constants, and has lengths for all axes of a text") {
  const Profile profile = table3[2].profile();
  BunchRequest request = natural_request(profile);
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
