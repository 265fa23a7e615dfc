#include "models/grammar/measures/measures.hpp"

#include <cmath>

#include "models/grammar/growing.hpp"
#include "models/grammar/measures/leaf_coverage.hpp"
#include "models/grammar/measures/measures.generated.hpp"
#include "near.hpp"
#include "spatial/surfaces.hpp"

namespace panicle::grammar {
namespace {

float of(const Plant& plant, Measure measure) { return plant.measures[static_cast<std::size_t>(measure)]; }

Plant measured(std::string text, std::vector<std::pair<std::string_view, float>> parameters = {},
               std::vector<ColumnView> more = {}) {
  Plant plant = grow(
      {.text = std::move(text), .parameters = std::move(parameters), .outputs = "measures", .more = std::move(more)});
  REQUIRE(plant.measures.size() == measure_count);
  return plant;
}

TEST_CASE("a Koch curve has the length of theory, and is flat") {
  const Plant plant =
      measured("derivation length: 3\naxiom: F(1)\nF(s) --> F(s/3) +(60) F(s/3) -(120) F(s/3) +(60) F(s/3)\n");
  CHECK(of(plant, Measure::segments) == 64);
  CHECK(of(plant, Measure::modules) == 64 + 63);
  CHECK(of(plant, Measure::line_length) == near(0.01 * 64 / 27, 1e-4));
  CHECK(of(plant, Measure::height) == near(1, 1e-4));
  CHECK(of(plant, Measure::spread) == near(0.5 * std::sqrt(3.0) / 6, 1e-4));
  CHECK(of(plant, Measure::box_volume) < 1e-9f);
  CHECK(of(plant, Measure::tips) == 1);
  CHECK(of(plant, Measure::forks) == 0);
  CHECK(of(plant, Measure::axes) == 1);
  CHECK(of(plant, Measure::axis_order) == 0);
  CHECK(of(plant, Measure::order) == 1);
  CHECK(std::isnan(of(plant, Measure::bifurcation)));
  CHECK(std::isnan(of(plant, Measure::fork_angle)));
  CHECK(std::isnan(of(plant, Measure::areas)));
  CHECK(std::isnan(of(plant, Measure::clothed)));
  CHECK(of(plant, Measure::organs) == 0);
  CHECK(of(plant, Measure::leaf_area) == 0);
}

TEST_CASE("a binary tree has the tips, axes and orders of theory") {
  const Plant plant =
      measured("axiom: A(5)\nA(n) : n>1 --> !(0.1) F [+(40) A(n-1)] [-(40) A(n-1)]\nA(n) --> !(0.1) F\n");
  CHECK(of(plant, Measure::segments) == 31);
  CHECK(of(plant, Measure::tips) == 16);
  CHECK(of(plant, Measure::forks) == 15);
  CHECK(of(plant, Measure::axes) == 31);
  CHECK(of(plant, Measure::axis_order) == 4);
  CHECK(of(plant, Measure::order) == 5);
  CHECK(of(plant, Measure::bifurcation) == near(2, 1e-4));
  CHECK(of(plant, Measure::fork_angle) == near(80, 1e-3));
  CHECK(of(plant, Measure::line_length) == near(0.31, 1e-4));
  // Cylinders 10 mm long and 1 mm thick.
  CHECK(of(plant, Measure::line_volume) == near(31 * 3.14159265 * 0.05 * 0.05, 1e-3));
}

TEST_CASE("an axis continues after its brackets, and counts where it has lines") {
  const Plant plant = measured("axiom: F [ +F [ -F ] F ] [ f @O ] [ [ [ f +F ] ] ] F\n");
  CHECK(of(plant, Measure::axes) == 4);
  CHECK(of(plant, Measure::axis_order) == 3);
  CHECK(of(plant, Measure::organs) == 1);
}

TEST_CASE("attached organs count in the leaf area and in the box") {
  const std::string squares = "{ . f + f + f . } f(3) { . f + f + f . }";
  const Plant plant = measured("axiom: @M(0,0,0) " + squares + "\n", {{"unit", 100}});
  CHECK(of(plant, Measure::polygons) == 2);
  CHECK(of(plant, Measure::organs) == 2);
  CHECK(of(plant, Measure::leaf_area) == near(200, 1e-4));
  CHECK(std::isnan(of(plant, Measure::tips)));
  const float one = of(measured("axiom: ~leaf(1)\n", {{"unit", 100}}), Measure::leaf_area);
  CHECK(one > 20);
  CHECK(one < 40);
  CHECK(of(measured("axiom: ~leaf(2) ~petal(9)\n", {{"unit", 100}}), Measure::leaf_area) == near(4 * one, 1e-4));
  const Plant ball = measured("axiom: @O(1) [f(2) @O(1)] [+f(2) @O(1)] [&f(2) @O(1)]\n", {{"unit", 100}});
  CHECK(of(ball, Measure::height) == near(30, 1e-4));
  CHECK(of(ball, Measure::spread) == near(30, 1e-4));
  CHECK(of(ball, Measure::box_volume) == near(27, 1e-4));
}

// Blocks of areas of one kind, whose middle is the origin.
struct OneArea {
  std::vector<std::uint32_t> kinds, meshes, triangles;
  std::vector<float> places, points;

  OneArea(Volume::Kind kind, glm::vec3 size, const Surface& mesh = {})
      : kinds{static_cast<std::uint32_t>(kind)},
        meshes{static_cast<std::uint32_t>(mesh.points.size()), static_cast<std::uint32_t>(mesh.triangles.size() / 3)},
        triangles(mesh.triangles),
        places{0, 0, 0, size.x, size.y, size.z, 0, 0.6f, 0, 0.8f} {
    for (const glm::vec3& point : mesh.points) put(points, point);
  }
  std::vector<ColumnView> views() const {
    const auto view = [](std::string_view name, Element element, std::uint32_t width, const auto& values) {
      return ColumnView{name, element, width, static_cast<std::uint32_t>(values.size() / width),
                        reinterpret_cast<const std::uint8_t*>(values.data())};
    };
    return {view("areas.kinds", Element::uint32, 1, kinds), view("areas.meshes", Element::uint32, 2, meshes),
            view("areas.triangles", Element::uint32, 3, triangles), view("areas.places", Element::float32, 10, places),
            view("areas.points", Element::float32, 3, points)};
  }
};

TEST_CASE("growth areas have the volume of their form, and are clothed within the reach of leaves") {
  using Kind = Volume::Kind;
  constexpr double pi = 3.14159265358979;
  const auto grown = [](const OneArea& area, std::string text) {
    return measured(std::move(text), {{"unit", 1000}}, area.views());
  };
  const glm::vec3 size(1, 2, 3);
  const std::string far = "axiom: f(9) ~leaf\n";
  CHECK(of(grown({Kind::box, size}, far), Measure::area_volume) == near(6, 1e-5));
  CHECK(of(grown({Kind::sphere, size}, far), Measure::area_volume) == near(pi / 6, 1e-5));
  CHECK(of(grown({Kind::ellipsoid, size}, far), Measure::area_volume) == near(pi, 1e-5));
  CHECK(of(grown({Kind::cylinder, size}, far), Measure::area_volume) == near(6 * pi / 4, 1e-5));
  CHECK(of(grown({Kind::cone, size}, far), Measure::area_volume) == near(6 * pi / 12, 1e-5));
  // An edge of 8 stretched to 1, of 4 to 2 and of 2 to 3: the corner of three cubes' depth keeps its share of the box.
  const Surface mesh = box({0, 0, 0}, {8, 4, 2});
  const Plant bare = grown({Kind::mesh, size, mesh}, far);
  CHECK(of(bare, Measure::area_volume) == near(6, 1e-5));
  CHECK(of(bare, Measure::areas) == 1);
  CHECK(of(bare, Measure::clothed) == 0);
  CHECK(column_in<float>(bare.columns, "areas.clothed") == std::vector<float>{0});
  CHECK(column_in<float>(bare.columns, "areas.volume")[0] == near(6, 1e-5));
  CHECK(of(grown({Kind::box, size}, "axiom: ~leaf(2)\n"), Measure::clothed) == 1);
  // A ball of radius 0.5: from its surface a leaf of length r covers the cap whose share is r².
  CHECK(of(grown({Kind::sphere, size}, "axiom: f(0.5) ~leaf(0.4)\n"), Measure::clothed) == near(0.16, 0.05));
  CHECK(of(grown({Kind::sphere, size}, "axiom: f(0.5) ~petal(0.4)\n"), Measure::clothed) == 0);
}

TEST_CASE("an input of the grammar is each area's largest extent, in its unit") {
  const std::string text = "#input size[]\naxiom: F(size[1])\n";
  const auto largest_extent = [&](std::vector<ColumnView> views) {
    return of(measured(text, {{"unit", 10}}, std::move(views)), Measure::line_length);
  };
  const OneArea box(Volume::Kind::box, {1, 3, 2}), ball(Volume::Kind::sphere, {1, 3, 2});
  CHECK(largest_extent(box.views()) == near(3, 1e-5));
  CHECK(largest_extent(ball.views()) == near(1, 1e-5));
  CHECK(largest_extent({}) == near(1, 1e-5));
}

TEST_CASE("each leaf clothes the surface within its own length") {
  // A square 2 across: a quarter of its surface is within 1 of a corner's leaf, but for the curve of the circle.
  Surface square{{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}, {0, 2, 1, 0, 3, 2}};
  const double quarter = 3.14159265 / 4;
  CHECK(LeafCoverage({{{-1, 0, -1}, 1}}).share_of(square) == near(quarter / 4, 0.03));
  CHECK(LeafCoverage({{{-1, 0, -1}, 1}, {{1, 0, 1}, 0.5f}}).share_of(square) == near(1.25 * quarter / 4, 0.03));
  CHECK(LeafCoverage({}).share_of(square) == 0);
  CHECK(LeafCoverage({{{0, 0, 0}, 9}}).share_of({}) == 0);
}

TEST_CASE("a plant has measures where they are requested") {
  CHECK(grow({.text = "axiom: F\n"}).measures.empty());
  const Plant nothing = measured("axiom: A\n");
  CHECK(of(nothing, Measure::height) == 0);
  CHECK(of(nothing, Measure::line_length) == 0);
}

}  // namespace
}  // namespace panicle::grammar
