#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "foundation/english.hpp"
#include "foundation/random.hpp"
#include "models/leaf/leaf_growing.hpp"
#include "models/leaf/measures/measures.generated.hpp"
#include "models/leaf/outlines.hpp"
#include "models/particles/outline.hpp"

using namespace panicle;
using namespace panicle::particles;
using namespace panicle::particles::leaf;

namespace {

Outline outline_of(const Plant& plant) {
  const auto margin = column_at<float>(plant, "margin");
  std::vector<glm::vec2> points;
  for (std::size_t i = 0; i < margin.size(); i += 2) points.push_back({margin[i], margin[i + 1]});
  return Outline(points);
}

// A random star with bays, as a user may drag it.
std::vector<float> random_outline(std::uint64_t seed) {
  Half half{{0, 0, 1}};
  const std::int32_t points = random_integer(seed, 1, 0, 3, 9);
  for (std::int32_t k = 1; k <= points; ++k) {
    const float t = static_cast<float>(k) / static_cast<float>(points + 1);
    const auto at = static_cast<std::uint64_t>(k);
    half.push_back({0.08f + 0.5f * random_unit(seed, 2, at), t, static_cast<float>(random_integer(seed, 3, at, 0, 3))});
  }
  half.push_back({0, 1, 3});
  return mirrored(half);
}

// Checks the properties of every leaf: energy, one tree a target, parents first, trails in the outline within a step.
void check_leaf(const Plant& plant, double energy, float step) {
  const auto energies = column_at<float>(plant, "segments.energy"), arrived = column_at<float>(plant, "targets.energy");
  const auto chart = column_at<float>(plant, "segments.chart");
  const auto order = column_at<std::uint32_t>(plant, "segments.order");
  const std::size_t count = plant.segments.size();
  REQUIRE(energies.size() == count);
  REQUIRE(chart.size() == 4 * count);
  REQUIRE(order.size() == count);
  double sum = 0;
  for (const float one : arrived) sum += static_cast<double>(one);
  CHECK(sum == energy * count_at(plant, "particles"));
  const Outline outline = outline_of(plant);
  const float reach = step * std::sqrt(outline.area() / static_cast<float>(std::max(count_at(plant, "particles"), 1u)));
  std::vector<double> inflow(count, 0);
  double at_targets = 0;
  for (std::size_t i = count; i-- > 0;) {
    const Segment& segment = plant.segments[i];
    REQUIRE(segment.parent < static_cast<std::int32_t>(i));
    CHECK(inflow[i] <= static_cast<double>(energies[i]));
    CHECK(order[i] >= 1);
    if (segment.parent < 0) {
      at_targets += static_cast<double>(energies[i]);
    } else {
      const auto parent = static_cast<std::size_t>(segment.parent);
      inflow[parent] += static_cast<double>(energies[i]);
      CHECK(segment.start == plant.segments[parent].end);
      CHECK(order[i] >= order[parent]);
    }
    // Tests points along each segment, for a segment may be long.
    const glm::vec3 from(chart[4 * i], chart[4 * i + 1], 0), to(chart[4 * i + 2], chart[4 * i + 3], 0);
    for (float t = 0; t <= 1; t += 0.25f) {
      const glm::vec3 p = from + t * (to - from);
      CHECK((outline.contains(p) || outline.distance(p) <= reach));
    }
  }
  // Particles that start at the target itself have no way to go.
  CHECK(at_targets <= sum);
}

}  // namespace

TEST_CASE(
    "energy arrives whole, trails are one tree a target and stay in the outline, whatever its shape and the ribs") {
  for (const NamedOutline& named : leaf_outlines())
    for (const float ribs : {0.0f, 1.0f, 2.0f, 3.0f}) {
      CAPTURE(std::string(named.name));
      CAPTURE(ribs);
      const Plant plant =
          leaf_of({{{Parameter::ribs, ribs}, {Parameter::particles, 500}, {Parameter::energy, 3}}, named.rows});
      check_leaf(plant, 3, 0.35f);
      CHECK(count_at(plant, "particles") > 400);
      const auto targets = count_at(plant, "targets");
      if (ribs <= 1) CHECK(targets == 1);
      if (ribs == 3) CHECK(targets == 17);
    }
}

TEST_CASE("random outlines, seeds and rules give sound leaves") {
  std::size_t refused = 0;
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    const auto chance = [&](std::uint64_t stream) { return random_unit(seed, stream, 7); };
    CropTarget wish{.outline = random_outline(seed), .seed = seed};
    wish.parameters = {{Parameter::particles, std::floor(1 + 600 * chance(1))},
                       {Parameter::pattern, static_cast<float>(seed % 3)},
                       {Parameter::ribs, static_cast<float>(seed % 4)},
                       {Parameter::step, 0.1f + chance(2)},
                       {Parameter::merge, 2 * chance(3)},
                       {Parameter::pull, 3 * chance(4)},
                       {Parameter::rule, seed % 5 == 0 ? 1.0f : 0.0f},
                       {Parameter::join, chance(5)},
                       {Parameter::slant, 2 * chance(6)},
                       {Parameter::teeth, std::floor(30 * chance(7))},
                       {Parameter::smoothing, seed % 3 == 0 ? 0.0f : 1.0f}};
    const auto plant = grown(wish);
    if (!plant) {
      CHECK(english(plant.error().message).find("crosses itself") != std::string::npos);
      ++refused;
      continue;
    }
    check_leaf(plant.value(), 1, wish.parameters[Parameter::step]);
  }
  CHECK(refused < 30);
}

TEST_CASE("a palmate leaf has a tree for each lobe, a pinnate one a midrib and about the requested side veins") {
  const auto outlines = leaf_outlines();
  const auto grape =
      std::find_if(outlines.begin(), outlines.end(), [](const auto& one) { return one.name == "grapevine"; });
  const Plant palmate = leaf_of({{{Parameter::ribs, 2}}, grape->rows, 1, "measures"});
  CHECK(count_at(palmate, "targets") == 5);
  const auto measure = [](const Plant& plant, Measure key) { return plant.measures[static_cast<std::size_t>(key)]; };
  CHECK(measure(palmate, Measure::count_1) >= 3);
  CHECK(measure(palmate, Measure::count_1) <= 5);

  const Plant pinnate =
      leaf_of({{{Parameter::secondaries, 9}, {Parameter::angle, 60}, {Parameter::arch, 0}}, {}, 1, "measures"});
  CHECK(measure(pinnate, Measure::count_1) == 1);
  CHECK(measure(pinnate, Measure::count_2) >= 11);
  CHECK(measure(pinnate, Measure::count_2) <= 20);
  CHECK(measure(pinnate, Measure::secondary_angle) == doctest::Approx(60).epsilon(0.15));
  const Plant steeper =
      leaf_of({{{Parameter::secondaries, 9}, {Parameter::angle, 35}, {Parameter::arch, 0}}, {}, 1, "measures"});
  CHECK(measure(steeper, Measure::secondary_angle) < measure(pinnate, Measure::secondary_angle) - 10);
  // Fewer particles are farther apart.
  const Plant fewer =
      leaf_of({{{Parameter::secondaries, 5}, {Parameter::angle, 60}, {Parameter::arch, 0}}, {}, 1, "measures"});
  CHECK(measure(fewer, Measure::secondary_spacing) > 1.3f * measure(pinnate, Measure::secondary_spacing));
}

TEST_CASE("the same request gives the same leaf, another seed another") {
  const CropTarget wish{{{Parameter::particles, 300}}, {}, 5, "meshes mesh_fingerprint"};
  const Plant one = leaf_of(wish), again = leaf_of(wish);
  CHECK(one.fingerprint == again.fingerprint);
  CHECK(one.mesh_fingerprint == again.mesh_fingerprint);
  CHECK(one.mesh_fingerprint != 0);
  CHECK(leaf_of({{{Parameter::particles, 300}}, {}, 6}).fingerprint != one.fingerprint);
}

TEST_CASE("inputs out of range are clamped with a note, invalid ones refused with a message") {
  const Plant wild =
      leaf_of({{{Parameter::particles, 1e9f}, {Parameter::age, 100}, {Parameter::teeth, -4}}, {}, 1, "", {99}});
  CHECK(count_at(wild, "particles") > 19000);
  CHECK(count_at(wild, "particles") < 21000);
  CHECK(wild.notes.size() == 3);
  CHECK(leaf_of({{{Parameter::length, absent}}}).notes.empty());
  const auto far = grown({{}, {0, 0, 1, 1, 0, 0, std::numeric_limits<float>::infinity(), 1, 0}});
  REQUIRE_FALSE(far);
  CHECK(far.error().reason == Reason::bad_input);
  // A petiole that would join in the air joins at the margin.
  const Plant away = leaf_of({{{Parameter::particles, 100}}, {1, 1, 1, 2, 1, 1, 1.5f, 2, 3}});
  REQUIRE(away.notes.size() >= 1);
  CHECK(english(away.notes[0]).find("petiole") != std::string::npos);
  check_leaf(away, 1, 0.35f);
}

TEST_CASE("a leaf whose particles run too long, or leave too many segments, is refused") {
  const auto refusal = [](const Limits& limits) {
    const auto leaf = grown({{{Parameter::particles, 300}, {Parameter::step, 0.05f}, {Parameter::ribs, 2}}}, limits);
    REQUIRE_FALSE(leaf);
    CHECK(leaf.error().reason == Reason::limit);
    return english(leaf.error().message);
  };
  CHECK(refusal({.moves = 1000}).find("still moving after 1000 moves") != std::string::npos);
  CHECK(refusal({.pieces = 100}).find("pieces of branches, roots or veins; the limit is 100") != std::string::npos);
}
