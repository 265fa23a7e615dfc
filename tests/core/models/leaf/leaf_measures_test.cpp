#include <doctest/doctest.h>

#include <cmath>

#include "models/leaf/leaf_growing.hpp"
#include "models/leaf/measures/measures.generated.hpp"
#include "models/leaf/measures/measures.hpp"
#include "models/particles/outline.hpp"

using namespace panicle;
using namespace panicle::particles;
using namespace panicle::particles::leaf;

TEST_CASE("measures follow from geometry") {
  // A square of 100 mm, its corners sharp, one particle: a straight vein.
  const std::vector<float> square{-0.5f, 0, 1, 0.5f, 0, 1, 0.5f, 1, 1, -0.5f, 1, 1};
  const Plant plant = leaf_of({{{Parameter::length, 100},
                                {Parameter::ribs, 0},
                                {Parameter::particles, 1},
                                {Parameter::pattern, 0},
                                {Parameter::vein, 2}},
                               square,
                               3,
                               "measures"});
  const auto measure = [&](Measure key) { return plant.measures[static_cast<std::size_t>(key)]; };
  CHECK(measure(Measure::area) == doctest::Approx(100));
  CHECK(measure(Measure::perimeter) == doctest::Approx(400));
  CHECK(measure(Measure::leaf_length) == doctest::Approx(100));
  CHECK(measure(Measure::leaf_width) == doctest::Approx(100));
  CHECK(measure(Measure::slenderness) == doctest::Approx(1));
  CHECK(measure(Measure::roundness) == doctest::Approx(3.14159 / 4).epsilon(1e-4));
  const auto chart = column_at<float>(plant, "segments.chart");
  REQUIRE(plant.segments.size() == 1);
  const float length = 100 * std::hypot(chart[2] - chart[0], chart[3] - chart[1]);
  CHECK(measure(Measure::vein_length) == doctest::Approx(length));
  CHECK(measure(Measure::vein_density) == doctest::Approx(length / 10000));
  CHECK(measure(Measure::vein_area) == doctest::Approx(2 * length / 10000));
  CHECK(measure(Measure::density_1) == doctest::Approx(length / 1000));
  CHECK(measure(Measure::ends) == 1);
  CHECK(measure(Measure::forks) == 0);
  CHECK(measure(Measure::orders) == 1);
  CHECK(measure(Measure::count_1) == 1);
  CHECK(measure(Measure::count_2) == 0);
  CHECK(std::isnan(measure(Measure::secondary_angle)));
  CHECK(std::isnan(measure(Measure::secondary_spacing)));
}

TEST_CASE("angles and spacings of secondaries are those of a drawn leaf") {
  // A midrib of 1 with side veins of 60° at 0.2, 0.5 and 0.7 on the right, and of 45° at 0.4 on the left.
  Trails trails;
  const auto add = [&](glm::vec3 place, std::int32_t next, double energy) {
    trails.places.push_back(place);
    trails.next.push_back(next);
    trails.energy.push_back(energy);
    return static_cast<std::int32_t>(trails.places.size()) - 1;
  };
  std::int32_t last = add({0, 0, 0}, -1, 100);
  std::vector<std::int32_t> midrib{last};
  for (int k = 1; k <= 10; ++k) midrib.push_back(last = add({0, 0.1f * static_cast<float>(k), 0}, last, 100 - 9 * k));
  const float out = 0.2f * std::sqrt(3.0f);
  for (const int k : {2, 5, 7})
    add({out, 0.1f * static_cast<float>(k) + 0.2f, 0}, midrib[static_cast<std::size_t>(k)], 8);
  add({-0.2f, 0.6f, 0}, midrib[4], 8);
  trails.born.assign(trails.size(), 0);
  trails.particle.assign(trails.size(), -1);
  const std::vector<Trails> crowds{trails};
  const std::vector<Vein> veins = veins_of(crowds);
  const Margin margin{.points = {{-1, 0}, {1, 0}, {1, 1}, {-1, 1}}, .controls = {}, .tips = {}, .tip = 0, .teeth = {}};
  const Outline outline(margin.points);
  const std::vector<double> all{100};
  const Girth girth{.thickest = 0.001f};
  const auto measures = measures_of({margin, outline, crowds, veins, all, girth, 0.1f});
  const auto measure = [&](Measure key) { return measures[static_cast<std::size_t>(key)]; };
  CHECK(measure(Measure::count_1) == 1);
  CHECK(measure(Measure::count_2) == 4);
  CHECK(measure(Measure::secondary_angle) == doctest::Approx((60 * 3 + 45) / 4.0).epsilon(1e-3));
  CHECK(measure(Measure::secondary_spacing) == doctest::Approx(25).epsilon(1e-3));
  CHECK(measure(Measure::density_1) == doctest::Approx(10.0 / 200));
  CHECK(measure(Measure::forks) == 4);
  CHECK(measure(Measure::ends) == 5);
  CHECK(std::isnan(measure(Measure::primary_angle)));
}

TEST_CASE("the angle between primaries is the mean over neighbours") {
  // Three targets' trails, at −50°, 0° and 60° from upwards.
  std::vector<Trails> crowds;
  for (const float degrees : {-50.0f, 60.0f, 0.0f}) {
    const float turned = degrees * 3.14159265f / 180;
    crowds.push_back({.places = {{0, 0, 0}, {std::sin(turned), std::cos(turned), 0}},
                      .next = {-1, 0},
                      .energy = {10, 10},
                      .born = {0, 0},
                      .particle = {-1, 0}});
  }
  const std::vector<Vein> veins = veins_of(crowds);
  const Margin margin{
      .points = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, .controls = {}, .tips = {}, .tip = 0, .teeth = {}};
  const Outline outline(margin.points);
  const std::vector<double> all{30, 30, 30};
  const auto measures = measures_of({margin, outline, crowds, veins, all, {.thickest = 0.001f}, 0.1f});
  CHECK(measures[static_cast<std::size_t>(Measure::primary_angle)] == doctest::Approx(55).epsilon(1e-3));
}
