#include "lsystem_plant/plain_plant.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string>

#include "foundation/english.hpp"
#include "mesh/uv_sphere.hpp"

using namespace panicle;

namespace {

Plant drawn(const std::string& text, PlainOptions options = {}, const Limits& limits = {}) {
  auto program = lsystem::compile(text, limits, lsystem::Lineages::always);
  REQUIRE(program);
  auto plant = draw_plainly(program.value(), {}, options, limits);
  REQUIRE(plant);
  return plant.value();
}

glm::vec3 turned(const glm::vec4& q, const glm::vec3& v) {
  const glm::vec3 axis(q.x, q.y, q.z);
  return v + 2.0f * glm::cross(axis, glm::cross(axis, v) + q.w * v);
}

}  // namespace

TEST_CASE("every module that draws is a segment or an organ of its own, in metres, parents first") {
  const Plant plant = drawn("axiom: !(4)F(100)[+(90)F(50)S(10)]!(2)F(30)");
  REQUIRE(plant.segments.size() == 3);
  CHECK(plant.segments[0].parent == -1);
  CHECK(plant.segments[1].parent == 0);
  CHECK(plant.segments[2].parent == 0);
  CHECK(plant.segments[0].end.y == doctest::Approx(-0.1));
  CHECK(plant.segments[2].end.y == doctest::Approx(-0.13));
  CHECK(plant.segments[0].radius == doctest::Approx(0.002));
  CHECK(plant.segments[2].radius_end == doctest::Approx(0.001));
  REQUIRE(plant.organs.size() == 1);
  const Organ& ball = plant.organs[0];
  CHECK(ball.segment == 1);
  CHECK(ball.scale == doctest::Approx(0.01));
  // One radius beyond the side branch's tip, along its heading.
  CHECK(glm::distance(ball.position, plant.segments[1].end) == doctest::Approx(0.01));
  const glm::vec3 heading = glm::normalize(plant.segments[1].end - plant.segments[1].start);
  CHECK(glm::distance(turned(ball.rotation, {0, 1, 0}), heading) < 1e-5f);
  CHECK(plant.meshes[static_cast<std::size_t>(ball.mesh)].name == "balls");
}

TEST_CASE("a ball that hangs straight down is turned half round") {
  const Plant plant = drawn("axiom: F(10)S(1)");
  CHECK(glm::distance(turned(plant.organs[0].rotation, {0, 1, 0}), glm::vec3(0, -1, 0)) < 1e-5f);
}

TEST_CASE("meshes are made only when requested, and the fingerprint stays the same") {
  PlainOptions bare;
  bare.meshes = false;
  const std::string text = "axiom: F(10)[+F(5)]S(2)";
  const Plant without = drawn(text, bare), with = drawn(text);
  CHECK(without.meshes.empty());
  CHECK(without.organs[0].mesh == -1);
  REQUIRE(with.meshes.size() == 2);
  CHECK(with.meshes[0].name == "stems");
  CHECK(with.meshes[0].mesh.positions.size() > 0);
  CHECK(with.fingerprint == without.fingerprint);
  CHECK(with.mesh_fingerprint == 0);
  PlainOptions printed;
  printed.mesh_fingerprint = true;
  CHECK(drawn(text, printed).mesh_fingerprint != 0);
}

TEST_CASE("the fingerprint notices every number of a segment and of an organ") {
  const Plant plant = drawn("axiom: F(10)[+(40)F(5)]S(2)");
  std::set<std::uint64_t> prints{plant.fingerprint};
  const auto change = [&](auto&& edit) {
    Plant other = plant;
    edit(other);
    prints.insert(fingerprint_of(other));
  };
  change([](Plant& p) { p.segments[1].parent = -1; });
  change([](Plant& p) { p.segments[1].tag = 1; });
  change([](Plant& p) { p.segments[1].start.x += 1; });
  change([](Plant& p) { p.segments[1].end.z += 1; });
  change([](Plant& p) { p.segments[1].radius += 1; });
  change([](Plant& p) { p.segments[1].radius_end += 1; });
  change([](Plant& p) { p.organs[0].tag = 1; });
  change([](Plant& p) { p.organs[0].segment = 1; });
  change([](Plant& p) { p.organs[0].position.y += 1; });
  change([](Plant& p) { p.organs[0].rotation.z += 1; });
  change([](Plant& p) { p.organs[0].scale += 1; });
  CHECK(prints.size() == 12);
}

TEST_CASE("a drawing without lines has a note; one beyond the limits is an error") {
  const Plant nothing = drawn("axiom: +f(3)");
  REQUIRE(nothing.notes.size() == 1);
  CHECK(english(nothing.notes[0]) ==
        "The grammar does not draw anything; add a symbol that draws, such as “F” for a line.");
  Limits few;
  few.segments = 5;
  const auto program = lsystem::compile("axiom: F F F F F F F", few, lsystem::Lineages::always);
  REQUIRE(program);
  const auto plant = draw_plainly(program.value(), {}, {}, few);
  REQUIRE_FALSE(plant);
  CHECK(plant.error().reason == Reason::limit);
  CHECK(english(plant.error().message).find("5 segments") != std::string::npos);
}

TEST_CASE("draw_plainly takes the requested steps, else the text's") {
  const char* text = "derivation length: 3\naxiom: A\nA --> F(1) A";
  CHECK(drawn(text).segments.size() == 3);
  PlainOptions younger;
  younger.steps = 2;
  CHECK(drawn(text, younger).segments.size() == 2);
}

TEST_CASE("ignored parts of a text become notes") {
  CHECK(drawn("axiom: F(1)").notes.empty());
  const std::vector<std::string> notes = drawn("axiom: F(1)\nA : ran(1)<0.5 --> F2").notes;
  REQUIRE(notes.size() == 2);
  CHECK(english(notes[0]) == "Line 2, column 20: “F2” is read as a single symbol, which draws nothing; write “F(2)”.");
  CHECK(english(notes[1]).find("Line 2, column 1: The random condition of “A”") == 0);
}

TEST_CASE("the ball is closed, round and faces outwards") {
  const Mesh ball = make_uv_sphere(12);
  double volume = 0;
  const auto at = [&](std::uint32_t i) {
    return glm::vec3(ball.positions[3 * i], ball.positions[3 * i + 1], ball.positions[3 * i + 2]);
  };
  for (std::size_t t = 0; t < ball.indices.size(); t += 3) {
    const glm::vec3 a = at(ball.indices[t]), b = at(ball.indices[t + 1]), c = at(ball.indices[t + 2]);
    CHECK(glm::length(glm::cross(b - a, c - a)) > 1e-4f);
    volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  CHECK(volume > 0.8 * 4.18879);
  CHECK(volume < 4.18879);
}

TEST_CASE("balls and stems hide sky from each other, where requested") {
  PlainOptions options;
  options.sky = true;
  const auto column = [](const Columns& columns, std::string_view name) -> std::span<const std::uint8_t> {
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (columns[i].name == name) return columns[i].as<std::uint8_t>();
    return {};
  };
  const std::string lone = "axiom: F(10)S(4)", pair = "axiom: F(10)[+(90)F(2)S(4)][-(90)F(2)S(4)]";
  const Plant one = drawn(lone, options), two = drawn(pair, options);
  CHECK(column(drawn(pair).columns, "organs.sky").empty());
  CHECK(column(drawn(pair).meshes[0].columns, "sky").empty());
  const auto alone = column(one.columns, "organs.sky"), together = column(two.columns, "organs.sky");
  REQUIRE(alone.size() == 1);
  CHECK(alone[0] == 255);  // its own stem hides nothing from it
  REQUIRE(together.size() == 2);
  CHECK(together[0] == together[1]);
  CHECK(together[0] < 253);
  CHECK(together[0] > 150);
  const auto stems = column(two.meshes[0].columns, "sky");
  REQUIRE(stems.size() == two.meshes[0].mesh.positions.size() / 3);
  CHECK(*std::min_element(stems.begin(), stems.end()) < 150);
  CHECK(*std::max_element(stems.begin(), stems.end()) > 250);
}
