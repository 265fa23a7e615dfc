#include <algorithm>
#include <glm/geometric.hpp>

#include "foundation/english.hpp"
#include "lsystem_plant/messages.generated.hpp"
#include "models/grammar/growing.hpp"

namespace panicle::grammar {
namespace {

const std::string koch = "derivation length: 3\naxiom: F -(90) F -(90) F -(90) F\nF --> F + F - F - F F + F + F - F\n";

TEST_CASE("a quadratic island has as many segments as its rule gives") {
  const Plant plant = grow({.text = koch});
  CHECK(count_of(plant, "segments") == 4 * 8 * 8 * 8);
  CHECK(count_of(plant, "steps") == 3);
  CHECK(count_of(plant, "organs") == 0);
  CHECK(count_of(plant, "polygons") == 0);
  // Each F with the turn behind it, but the last.
  CHECK(count_of(plant, "modules") == 7 + 4 * (8 * 8 * 8 - 1) / 7 * (8 + 6 - 1));
  CHECK(plant.segments[0].start == glm::vec3(0));
  CHECK(plant.segments[0].end.y == doctest::Approx(0.01));
}

TEST_CASE("steps, constants and the unit are those of the request") {
  const std::string text = "#define a 2\n#input b\nderivation length: 5\naxiom: A\nA --> F(a*b) A\n";
  const Plant plant = grow({.text = text, .parameters = {{"unit", 100}}, .constants = {{"b", 3}}, .steps = 2});
  REQUIRE(count_of(plant, "segments") == 2);
  CHECK(plant.segments[1].end.y == doctest::Approx(2 * 6 * 0.1f));
  const Plant other = grow({.text = text, .constants = {{"a", 1}, {"b", 3}}, .steps = 0});
  CHECK(count_of(other, "segments") == 0);
  CHECK(count_of(other, "modules") == 1);
  CHECK(std::find(other.notes.begin(), other.notes.end(), message(messages::lsystem_plant::nothing_drawn).encoded()) !=
        other.notes.end());
  CHECK(try_grow({.text = text}).error().reason == Reason::bad_input);
}

TEST_CASE("the derived string reads back as an axiom that draws the same") {
  const std::string text = "derivation length: 4\naxiom: A(1)\nA(x) --> F(x) [ +(30) A(x*0.7) ] -(ran(9)) A(x/3)\n";
  const Plant plant = grow({.text = text, .outputs = "string"});
  const std::vector<char> string = column_in<char>(plant.columns, "string");
  const Plant again = grow({.text = "axiom: " + std::string(string.begin(), string.end())});
  CHECK(again.fingerprint == plant.fingerprint);
  CHECK(count_of(again, "modules") == count_of(plant, "modules"));
  CHECK(column_in<std::uint32_t>(again.columns, "segments.module") ==
        column_in<std::uint32_t>(plant.columns, "segments.module"));
}

TEST_CASE("segments and organs have the index of the module that drew them") {
  const Plant plant = grow({.text = "axiom: F [ +(30) F(2) S(1) ] F(3)\n"});
  CHECK(column_in<std::uint32_t>(plant.columns, "segments.module") == std::vector<std::uint32_t>{0, 3, 6});
  CHECK(column_in<std::uint32_t>(plant.columns, "organs.module") == std::vector<std::uint32_t>{4});
}

TEST_CASE("lines without a width are a share of their mean length at the tips, thicker towards the root") {
  const std::string text = "axiom: F(2) [ +(30) F(1) ] -(30) F(3)\n";
  const Plant plant = grow({.text = text, .parameters = {{"unit", 1000}, {"thickness", 10}, {"thickening", 0.5f}}});
  CHECK(plant.segments[1].radius == doctest::Approx(0.1));
  CHECK(plant.segments[2].radius == doctest::Approx(0.1));
  CHECK(plant.segments[0].radius == doctest::Approx(0.1 * std::sqrt(2)));
  const Plant even = grow({.text = text, .parameters = {{"unit", 1000}, {"thickness", 10}, {"thickening", 0}}});
  CHECK(even.segments[0].radius == doctest::Approx(0.1));
}

TEST_CASE("lines of a plant that is many lines large are thicker, up to a limit") {
  const auto thinnest = [](const char* steps) {
    const std::string text = std::string("derivation length: ") + steps + "\naxiom: F\nF --> F F\n";
    return grow({.text = text, .parameters = {{"unit", 1000}, {"thickness", 10}}}).segments[0].radius;
  };
  CHECK(thinnest("4") == doctest::Approx(0.05));
  CHECK(thinnest("5") == doctest::Approx(0.1));
  CHECK(thinnest("9") == doctest::Approx(0.05 * 3.75));
}

TEST_CASE("strokes that turn sharply are straight and meet at corners; stems that bend a little are one tube") {
  for (const char* angle : {"36", "60", "90", "120"}) {
    const std::string text = std::string("derivation length: 2\nangle increment: ") + angle +
                             "\naxiom: F - - F - - F\nF --> F + F - - F + F\n";
    const Plant plant = grow({.text = text, .parameters = {{"unit", 1000}}, .outputs = "meshes"});
    const PlantMesh* stems = mesh_of(plant, "stems");
    REQUIRE(stems);
    const std::vector<float>& at = stems->mesh.positions;
    float farthest = 0;
    for (std::size_t v = 0; v < at.size(); v += 3) {
      const glm::vec3 p(at[v], at[v + 1], at[v + 2]);
      // It begins on the ground.
      if (glm::length(p) < 4 * plant.segments[0].radius) continue;
      float nearest = 1e9f;
      for (const Segment& segment : plant.segments) {
        const glm::vec3 along = segment.end - segment.start;
        const float t = glm::clamp(glm::dot(p - segment.start, along) / glm::dot(along, along), 0.0f, 1.0f);
        nearest = std::min(nearest, glm::distance(p, segment.start + t * along) - segment.radius);
      }
      farthest = std::max(farthest, nearest);
    }
    INFO("turns of ", angle);
    CHECK(farthest < 1e-3f);
  }
  const auto tubes = [](const char* angle) {
    const Plant plant = grow({.text = std::string("axiom: F +(") + angle + ") F\n", .outputs = "meshes"});
    return mesh_of(plant, "stems")->mesh.positions.size();
  };
  CHECK(tubes("36") > tubes("34"));
}

TEST_CASE("a leaf at the outside of a dense crown is light, though its branch is dark") {
  const Plant plant = grow({.text = "derivation length: 3000\n#define n 3000\naxiom: A(0)\nA(i) : i<n --> [ /(137.5*i) "
                                    "&(acos(1-2*(i+0.5)/n)) f(1) ~leaf(0.25) ] A(i+1)\n",
                            .outputs = "meshes sky"});
  const auto sky = column_in<std::uint8_t>(plant.columns, "organs.sky");
  REQUIRE(sky.size() == 3000);
  double sum = 0;
  for (const std::uint8_t byte : sky) sum += byte;
  const double mean = sum / 3000;
  CHECK(mean > 90);
}

TEST_CASE("very many organs of a surface have a simpler mesh") {
  const auto triangles = [](const char* steps) {
    const Plant plant =
        grow({.text = std::string("derivation length: ") + steps + "\naxiom: A\nA --> ~leaf(1) f(1) A\n",
              .outputs = "meshes"});
    return mesh_of(plant, "leaf")->mesh.indices.size() / 3;
  };
  CHECK(4 * triangles("4001") <= triangles("4000"));
}

TEST_CASE("widths of the grammar are used, times the parameter") {
  const Plant plant =
      grow({.text = "axiom: F !(0.5) F [ !(0) F ] F\n", .parameters = {{"unit", 1000}, {"widths", 50}}});
  CHECK(plant.segments[1].radius == doctest::Approx(0.125));
  CHECK(plant.segments[3].radius == doctest::Approx(0.125));
  CHECK(plant.segments[0].radius == doctest::Approx(0.5 * 0.08 * std::pow(2, 0.3)));
  // A width of 0 is a hairline, not an unset width.
  CHECK(plant.segments[2].radius == doctest::Approx(0.1 * 0.5 * 0.08));
}

TEST_CASE("a limit that is reached ends the drawing, and what grew so far is shown with a note") {
  Limits limits;
  limits.pieces = 100;
  const Plant plant = grow({.text = koch, .limits = limits});
  CHECK(count_of(plant, "segments") == 100);
  REQUIRE(!plant.notes.empty());
  CHECK(english(plant.notes[0])
            .find("The plant is shown as far as it has grown. The plant reaches the limit of 100 segments") == 0);
}

TEST_CASE("invalid requests are refused with a message") {
  CHECK(try_grow({.text = ""}).error().reason == Reason::bad_request);
  const auto broken = try_grow({.text = "axiom: F(\n"});
  CHECK(broken.error().reason == Reason::syntax);
  CHECK(broken.error().line > 0);
}

TEST_CASE("meshes: tubes by their colours, balls; the sky of both") {
  const Plant plant = grow({.text = "axiom: F [ +(40) F S(0.3) ] [ -(40) F S(0.3) ] F\n", .outputs = "meshes sky"});
  const PlantMesh* stems = mesh_of(plant, "stems");
  REQUIRE(stems);
  CHECK(stems->runs.size() == 1);
  CHECK(column_in<std::uint8_t>(stems->columns, "colour") == std::vector<std::uint8_t>{1});
  CHECK(column_in<std::uint8_t>(stems->columns, "sky").size() == stems->mesh.positions.size() / 3);
  CHECK(column_in<std::uint8_t>(plant.columns, "organs.sky").size() == 2);
  CHECK(column_in<std::uint8_t>(plant.columns, "organs.colour") == std::vector<std::uint8_t>{7, 7});
  REQUIRE(plant.organs.size() == 2);
  CHECK(plant.meshes[static_cast<std::size_t>(plant.organs[0].mesh)].name == "balls");
  CHECK(plant.organs[0].scale == doctest::Approx(0.003));
}

TEST_CASE("where a limit cuts the trace short, segments and organs have no module index") {
  // Idle modules, which every step copies in one block.
  const std::string text = "axiom: A(300)\nA(n) : n>0 --> A(n-1) F S(1) Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q\n";
  const std::uint32_t step = 9999;
  const std::vector<ColumnView> request{
      {"chronicle_step", Element::uint32, 1, 1, reinterpret_cast<const std::uint8_t*>(&step)}};
  Limits limits;
  limits.work = 5000;
  for (const bool cut : {false, true}) {
    CAPTURE(cut);
    const Plant plant =
        grow({.text = text, .outputs = "chronicle", .limits = cut ? limits : Limits{}, .more = request});
    CHECK(plant.segments.size() == 300);
    const auto traced = column_in<std::uint32_t>(plant.columns, "chronicle.counts");
    CHECK((traced.back() == count_of(plant, "modules")) == !cut);
    for (const char* of : {"segments.module", "organs.module"}) {
      const auto modules = column_in<std::uint32_t>(plant.columns, of);
      CHECK(modules.size() == 300);
      CHECK(std::count(modules.begin(), modules.end(), 0xffffffffu) == (cut ? 300 : 0));
    }
  }
}

}  // namespace
}  // namespace panicle::grammar
