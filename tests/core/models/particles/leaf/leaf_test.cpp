#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <string>

#include "foundation/random.hpp"
#include "models/particles/leaf/measures/measures.generated.hpp"
#include "models/particles/leaf/measures/measures.hpp"
#include "models/particles/leaf/outlines.hpp"
#include "models/particles/leaf/parameters.generated.hpp"
#include "models/particles/outline.hpp"
#include "plant/model.hpp"

using namespace panicle;
using namespace panicle::particles;
using namespace panicle::particles::leaf;

namespace panicle::particles::leaf {
extern const Model model;
}

namespace {

constexpr float absent = std::numeric_limits<float>::quiet_NaN();

struct Wish {
  std::map<Parameter, float> parameters = {};
  std::vector<float> outline = {};
  std::uint32_t seed = 1;
  std::string outputs = "";
  std::vector<float> detail = {};
};

Result<Plant> grown(const Wish& wish, const Limits& limits = {}) {
  std::vector<float> parameters(parameter_count, absent);
  for (const auto& [key, value] : wish.parameters) parameters[static_cast<std::size_t>(key)] = value;
  const std::string name = "leaf";
  const std::uint32_t seed[] = {wish.seed};
  const auto view = [](std::string_view block, const auto& values) {
    using Value = std::remove_cvref_t<decltype(values[0])>;
    return ColumnView{block, element_of<Value>(), 1, static_cast<std::uint32_t>(std::size(values)),
                      reinterpret_cast<const std::uint8_t*>(std::data(values))};
  };
  std::vector<ColumnView> blocks{view("model", name), view("seed", seed), view("parameters", parameters)};
  if (!wish.outputs.empty()) blocks.push_back(view("outputs", wish.outputs));
  if (!wish.outline.empty()) blocks.push_back(view("outline", wish.outline));
  if (!wish.detail.empty()) blocks.push_back(view("detail", wish.detail));
  Request request(blocks, nullptr);
  return leaf::model.grow(request, limits);
}

Plant leaf_of(const Wish& wish) {
  auto plant = grown(wish);
  REQUIRE(plant);
  return std::move(plant.value());
}

template <class Value>
std::span<const Value> column_at(const Plant& plant, std::string_view name) {
  for (std::size_t i = 0; i < plant.columns.size(); ++i)
    if (plant.columns[i].name == name) return plant.columns[i].as<Value>();
  return {};
}

std::uint32_t count_at(const Plant& plant, std::string_view name) {
  for (const Count& count : plant.counts)
    if (count.name == name) return count.value;
  return 0;
}

Outline outline_of(const Plant& plant) {
  const auto margin = column_at<float>(plant, "margin");
  std::vector<glm::vec2> points;
  for (std::size_t i = 0; i < margin.size(); i += 2) points.push_back({margin[i], margin[i + 1]});
  return Outline(points);
}

const PlantMesh* mesh_at(const Plant& plant, std::string_view name) {
  for (const PlantMesh& mesh : plant.meshes)
    if (mesh.name == name) return &mesh;
  return nullptr;
}

// A star with bays, of luck's own: what a hand may drag.
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

// What holds of every leaf: energy, one tree a target, parents first, trails in the outline within a step.
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
    // In steps, for a segment may be long: everywhere on it.
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
      if (ribs == 2) CHECK(targets >= 1);
    }
}

TEST_CASE("so it is of outlines, seeds and rules at random") {
  std::size_t refused = 0;
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    const auto chance = [&](std::uint64_t stream) { return random_unit(seed, stream, 7); };
    Wish wish{.outline = random_outline(seed), .seed = seed};
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
      CHECK(plant.error().message.find("crosses itself") != std::string::npos);
      ++refused;
      continue;
    }
    check_leaf(plant.value(), 1, wish.parameters[Parameter::step]);
  }
  CHECK(refused < 30);
}

TEST_CASE("a palmate leaf has a tree for each lobe, a pinnate one a midrib and side veins about as many as asked") {
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
  // Fewer stand farther apart.
  const Plant fewer =
      leaf_of({{{Parameter::secondaries, 5}, {Parameter::angle, 60}, {Parameter::arch, 0}}, {}, 1, "measures"});
  CHECK(measure(fewer, Measure::secondary_spacing) > 1.3f * measure(pinnate, Measure::secondary_spacing));
}

TEST_CASE("the thickest vein is as wide as asked, and others by the law") {
  struct Case {
    float law, exponent, power;
  };
  for (const auto& [law, exponent, power] : {Case{0, absent, 1}, Case{1, absent, 0.5f}, Case{2, 0.33f, 0.33f}}) {
    const Plant plant = leaf_of(
        {{{Parameter::law, law}, {Parameter::exponent, exponent}, {Parameter::vein, 2}, {Parameter::particles, 300}}});
    const auto energy = column_at<float>(plant, "segments.energy");
    const float all = static_cast<float>(count_at(plant, "particles"));
    CHECK(plant.segments[0].radius == doctest::Approx(0.001 * std::pow(energy[0] / all, power)).epsilon(1e-3));
    for (std::size_t i = 0; i < plant.segments.size(); ++i)
      CHECK(plant.segments[i].radius ==
            doctest::Approx(std::max(0.001f * std::pow(energy[i] / all, power), 5e-6f)).epsilon(2e-3));
  }
}

TEST_CASE("a petiole is as thick as asked, however thick the veins are") {
  for (const auto& [vein, wide] : {std::pair{0.3f, 2.4f}, {3.0f, 1.2f}}) {
    const Plant plant = leaf_of(
        {{{Parameter::particles, 100}, {Parameter::vein, vein}, {Parameter::petiole_width, wide}}, {}, 1, "meshes"});
    const PlantMesh* stalk = mesh_at(plant, "petiole");
    REQUIRE(stalk != nullptr);
    // Where it meets the blade, at the origin: half of the girth there is half its thickness.
    float widest = 0;
    for (std::size_t i = 0; i + 2 < stalk->mesh.positions.size(); i += 3)
      if (std::fabs(stalk->mesh.positions[i + 1]) < 5e-4f)
        widest = std::max(widest, std::fabs(stalk->mesh.positions[i]));
    CHECK(widest == doctest::Approx(0.0005f * wide).epsilon(0.05));
  }
}

TEST_CASE("a growth is its request's: the same twice, another with another seed") {
  const Wish wish{{{Parameter::particles, 300}}, {}, 5, "meshes mesh_fingerprint"};
  const Plant one = leaf_of(wish), again = leaf_of(wish);
  CHECK(one.fingerprint == again.fingerprint);
  CHECK(one.mesh_fingerprint == again.mesh_fingerprint);
  CHECK(one.mesh_fingerprint != 0);
  CHECK(leaf_of({{{Parameter::particles, 300}}, {}, 6}).fingerprint != one.fingerprint);
}

TEST_CASE("age runs from scattered particles to whole trails, in the middle both stand") {
  const auto at = [](float age) {
    return leaf_of({{{Parameter::particles, 400}, {Parameter::age, age}}, {}, 1, "meshes"});
  };
  const Plant begin = at(0), middle = at(50), end = at(100);
  CHECK(begin.segments.empty());
  CHECK(begin.organs.size() == count_at(begin, "particles"));
  CHECK(middle.organs.size() < begin.organs.size());
  CHECK(middle.organs.size() > 0);
  CHECK(middle.segments.size() > 100);
  CHECK(end.organs.empty());
  CHECK(mesh_at(end, "particle") == nullptr);
  for (const Organ& organ : middle.organs) {
    REQUIRE(organ.mesh >= 0);
    CHECK(middle.meshes[static_cast<std::size_t>(organ.mesh)].name == "particle");
    CHECK(organ.scale > 0);
  }
  // Counts are of the whole growth.
  CHECK(count_at(middle, "steps") == count_at(end, "steps"));
  CHECK(count_at(middle, "energy") == count_at(end, "energy"));
}

TEST_CASE(
    "meshes come where they are asked for, with the sky where that is, and fewer triangles for less detail or a "
    "draft") {
  const auto triangles = [](const Plant& plant) { return mesh_at(plant, "upper")->mesh.indices.size() / 3; };
  const Plant full = leaf_of({{}, {}, 1, "meshes sky"}), light = leaf_of({{}, {}, 1, "meshes", {0.05f}});
  const Plant draft = leaf_of({{}, {}, 1, "meshes draft"});
  CHECK(leaf_of({}).meshes.empty());
  for (const char* name : {"upper", "lower", "petiole"}) {
    const PlantMesh* mesh = mesh_at(full, name);
    REQUIRE(mesh != nullptr);
    bool sky = false;
    for (std::size_t i = 0; i < mesh->columns.size(); ++i)
      if (mesh->columns[i].name == "sky") {
        sky = true;
        CHECK(mesh->columns[i].rows == mesh->mesh.positions.size() / 3);
      }
    CHECK(sky);
  }
  CHECK(mesh_at(full, "upper")->material == "blade");
  CHECK(mesh_at(full, "petiole")->material == "stem");
  CHECK(triangles(light) * 7 < triangles(full));
  CHECK(triangles(draft) * 2 < triangles(full));
  CHECK(count_at(draft, "particles") < 1000);
  const Plant bare = leaf_of({{{Parameter::petiole, 0}}, {}, 1, "meshes"});
  CHECK(mesh_at(bare, "petiole") == nullptr);
}

TEST_CASE("what is measured is geometry's") {
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

TEST_CASE("the angle between primaries is the mean of what is between neighbours") {
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

TEST_CASE("what a leaf cannot use is brought into its range with a note, or refused in words") {
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
  CHECK(away.notes[0].find("petiole") != std::string::npos);
  check_leaf(away, 1, 0.35f);
}

TEST_CASE("a leaf whose particles run for ever so long, or leave too much behind, is refused") {
  const auto refusal = [](const Limits& limits) {
    const auto leaf = grown({{{Parameter::particles, 300}, {Parameter::step, 0.05f}, {Parameter::ribs, 2}}}, limits);
    REQUIRE_FALSE(leaf);
    CHECK(leaf.error().reason == Reason::limit);
    return leaf.error().message;
  };
  CHECK(refusal({.moves = 1000}).find("After 1000 moves particles are still on their way") != std::string::npos);
  CHECK(refusal({.pieces = 100}).find("pieces of trail, more than 100") != std::string::npos);
}
