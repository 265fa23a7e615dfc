#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/mathematics.hpp"
#include "models/bunch/measures/balls.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using enum Measure;

namespace {

constexpr Measure shares[] = {coverage,   spill,         coverage_front, coverage_side, spill_front,  spill_side,
                              fill_ratio, visible_front, visible_side,   visible_mean,  pedicels_seen};

}  // namespace

TEST_CASE("the measures of one ball follow from geometry") {
  const Envelope envelope = block(30, 200);
  const Measured one(balls({{0, -100, 0}}, 10), hung(envelope));
  const double area = 100 * pi, volume = 4.0 / 3 * pi;
  CHECK(one[coverage] == about(area / envelope.area(0)));
  CHECK(one[spill] == 0);
  CHECK(one[bunch_length] == about(20, 1e-4));
  CHECK(one[bunch_width] == about(20, 1e-4));
  CHECK(one[berry_volume] == about(volume, 1e-4));
  CHECK(one[berry_weight] == about(1.08 * volume, 1e-4));
  CHECK(one[bunch_weight] == about(1.08 * volume, 1e-4));
  CHECK(one[compactness] == about(1.08 * volume / 4, 1e-4));
  CHECK(one[hull_volume] == about(volume));
  CHECK(one[fill_ratio] == about(1));
  CHECK(one[outline_volume] == about(envelope.volume() / 1000));
  CHECK(one[berry_count] == 1);
  CHECK(one[diameter] == about(20, 1e-4));
  CHECK(one[diameter_spread] == 0);
  CHECK(one[uniformity] == 2);
  CHECK(one[berry_shape] == 2);
  CHECK(one[visible_front] == 1);
  CHECK(one[visible_mean] == about(1, 1e-5));
  CHECK(one[gap] == about(20, 1e-4));
  CHECK(one[contacts] == 0);
  CHECK(std::isnan(one[pedicel_length]));
  CHECK(std::isnan(one[pedicels_seen]));
  CHECK(std::isnan(one[peduncle_length]));
}

TEST_CASE("a bunch weighs its berries at 1.08 and its stems, cones' frustums, at 1 gram a cubic centimetre") {
  GrownBunch grown = balls({{0, -50, 0}}, 10);
  const float berry = Measured(grown, {})[bunch_weight];
  CHECK(berry == about(1.08 * 4 * pi / 3, 1e-4));  // of 1 cm
  grown.internodes = {{{-1, 0, {0, 0, 0}, {0, -0.03f, 0}, 0.002f, 0.001f}, Kind::rachis},
                      {{0, 0, {0, -0.03f, 0}, {0.03f, -0.07f, 0}, 0.0015f, 0.0015f}, Kind::axis, State::grown, 0}};
  const double frustum = pi / 3 * 30 * (4 + 2 + 1), cylinder = pi * 50 * 2.25;
  CHECK(Measured(grown, {})[bunch_weight] - berry == about((frustum + cylinder) / 1000, 1e-3));
}

TEST_CASE("without berries or outlines only the measures that do not apply are NaN") {
  const Envelope envelope = block(30, 200);
  const Measured none(GrownBunch{}, hung(envelope));
  for (std::size_t k = 0; k < measure_count; ++k) {
    const bool applies = k == static_cast<std::size_t>(berry_count) || k == static_cast<std::size_t>(outline_volume);
    CHECK(std::isnan(none.values[k]) == !applies);
  }
  const Measured loose(balls(lattice(15, within(envelope)), 7), {});
  for (const Measure key : {coverage, coverage_front, coverage_side, spill, spill_front, spill_side, outline_volume})
    CHECK(std::isnan(loose[key]));
  for (const Measure key : {bunch_length, hull_volume, fill_ratio, density, visible_mean}) CHECK(loose[key] > 0);
}

TEST_CASE("the order of berries does not matter") {
  const Envelope envelope = spindle(45, 180);
  GrownBunch grown = balls(lattice(15, within(envelope)), 7.4f);
  for (std::size_t i = 0; i < grown.berries.size(); ++i) {
    grown.berries[i].centre += 0.002f * glm::vec3(uniform(3 * i), uniform(3 * i + 1), uniform(3 * i + 2));
    grown.traits[i].length *= 1 + 0.2f * uniform(i + 9000);
  }
  const Measured forwards(grown, hung(envelope));
  std::reverse(grown.berries.begin(), grown.berries.end());
  std::reverse(grown.traits.begin(), grown.traits.end());
  const Measured backwards(grown, hung(envelope));
  for (std::size_t k = 0; k < measure_count; ++k) {
    CAPTURE(k);
    if (!std::isnan(forwards.values[k])) CHECK(backwards.values[k] == about(forwards.values[k], 1e-4));
  }
}

TEST_CASE("twice the size is twice the lengths, eight times the volumes and the same shares") {
  const Envelope envelope = spindle(45, 180), large = spindle(45, 180, 2);
  std::vector<glm::vec3> places = lattice(17, within(envelope));
  const Measured once(balls(places, 8), hung(envelope));
  for (glm::vec3& place : places) place *= 2;
  const Measured twice(balls(places, 16), hung(large));
  for (const Measure key : {bunch_length, bunch_width, diameter, berry_length, gap})
    CHECK(twice[key] == about(2 * once[key], 1e-3));
  for (const Measure key : {bunch_weight, berry_volume, hull_volume, outline_volume, berry_weight})
    CHECK(twice[key] == about(8 * once[key], 1e-3));
  for (const Measure key : {coverage, fill_ratio, density, contacts, visible_mean})
    CHECK(twice[key] == about(once[key], 0.01));
}

TEST_CASE("grown bunches: density follows its control, the second outline hangs where the second bunch does") {
  const auto grown = [](Parameter key, float value) {
    BunchRequest request = tests::natural_request(tests::table3[2].profile());
    request.measures = true;
    tests::set(request, key, value);
    const auto result = grow(request);
    REQUIRE(result);
    REQUIRE(result->measures.size() == measure_count);
    return result->measures;
  };
  const auto of = [](const std::vector<float>& measures, Measure key) {
    return measures[static_cast<std::size_t>(key)];
  };
  float before = 0;
  for (const float requested : {1.0f, 3.0f, 5.0f, 7.0f, 9.0f}) {
    const float note = of(grown(Parameter::density, requested), density);
    CHECK(note > before + 0.5f);
    CHECK(std::abs(note - requested) < 2);
    before = note;
  }
  const std::vector<float> twofold = grown(Parameter::wing, 0.6f);
  CHECK(of(twofold, coverage_front) > 0.85f);
  CHECK(of(twofold, coverage_side) > 0.85f);
  CHECK(of(twofold, spill_front) < 0.06f);
}

TEST_CASE("bunches with extreme numbers give shares between 0 and 1 or NaN") {
  const float wild[] = {
      0, 1e-6f, 1e6f, 1e30f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()};
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    GrownBunch grown;
    std::uint64_t drawn = 10000 * seed;
    const auto draw = [&] { return uniform(drawn++); };
    const auto place = [&] { return 0.2f * glm::vec3(draw() - 0.5f, -draw(), draw() - 0.5f); };
    const auto count = static_cast<std::uint64_t>(40 * draw());
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto parent = static_cast<std::int32_t>(static_cast<float>(i) * draw()) - 1;
      grown.internodes.push_back({{parent, 0, place(), place(), 0.003f * draw(), 0}, Kind::pedicel, State::grown, 0});
      grown.berries.push_back({place(), 0.01f * draw(), glm::normalize(place() + glm::vec3(0, 0, 0.1f)), parent, 0});
      if (seed % 3 == 0) grown.berries.back().centre.x *= wild[seed / 3 % 6];
      grown.traits.push_back({0.02f * draw(), 0.04f * draw()});
      if (seed % 5 == 0) grown.traits.back().width *= wild[seed / 5 % 6];
    }
    Profile profile{600 * draw(), {}};
    for (SidePoint& side : profile.sides) side = {300 * draw(), 600 * draw()};
    std::vector<HungEnvelope> envelopes = hung(Envelope(profile, 0.43f, 20 * draw()));
    if (seed % 2) envelopes.push_back({envelopes[0].envelope, 25 + 95 * draw()});
    const Measured measured(grown, envelopes);
    for (const Measure key : shares) {
      if (key == fill_ratio || std::isnan(measured[key])) continue;
      CHECK(measured[key] >= 0);
      CHECK(measured[key] <= 1.00001f);
    }
  }
}

TEST_CASE("the volume of two outlines is the sum of both") {
  const Envelope large = block(30, 200), small = block(20, 90);
  const GrownBunch grown = balls({{0, -50, 0}}, 10);
  const Measured both(grown, {{large, 0}, {small, 55}});
  CHECK(both[outline_volume] == about((large.volume() + small.volume()) / 1000, 1e-4));
}
