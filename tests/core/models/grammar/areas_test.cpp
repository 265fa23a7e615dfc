#include "models/grammar/areas.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <sstream>

#include "foundation/english.hpp"
#include "foundation/random.hpp"
#include "grammar_files.hpp"
#include "models/grammar/growing.hpp"
#include "spatial/surfaces.hpp"

namespace panicle::grammar {
namespace {

using Kind = Volume::Kind;

std::string topiary() {
  std::ifstream file(panicle::tests::repository_folder() + "/wasm-core/grammars/grammar/topiary.lsys");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

struct Area {
  Kind kind = Kind::box;
  glm::vec3 centre{0}, size{1};
  glm::quat rotation{1, 0, 0, 0};
  Surface mesh = {};

  Volume volume() const { return {kind, centre, size, rotation, mesh}; }
};

// Areas as blocks of a request; the request must not outlive them.
struct Blocks {
  std::vector<std::uint32_t> kinds, meshes, triangles;
  std::vector<float> places, points, path;

  explicit Blocks(const std::vector<Area>& areas) {
    for (const Area& area : areas) {
      kinds.push_back(static_cast<std::uint32_t>(area.kind));
      for (const glm::vec3& v : {area.centre, area.size}) put(places, v);
      for (const float q : {area.rotation.x, area.rotation.y, area.rotation.z, area.rotation.w}) places.push_back(q);
      meshes.push_back(static_cast<std::uint32_t>(area.mesh.points.size()));
      meshes.push_back(static_cast<std::uint32_t>(area.mesh.triangles.size() / 3));
      for (const glm::vec3& point : area.mesh.points) put(points, point);
      triangles.insert(triangles.end(), area.mesh.triangles.begin(), area.mesh.triangles.end());
    }
  }
  std::vector<ColumnView> views() const {
    const auto view = [](std::string_view name, Element element, std::uint32_t width, const auto& values) {
      return ColumnView{name, element, width, static_cast<std::uint32_t>(values.size() / width),
                        reinterpret_cast<const std::uint8_t*>(values.data())};
    };
    return {view("areas.kinds", Element::uint32, 1, kinds),         view("areas.meshes", Element::uint32, 2, meshes),
            view("areas.triangles", Element::uint32, 3, triangles), view("areas.places", Element::float32, 10, places),
            view("areas.points", Element::float32, 3, points),      view("path", Element::float32, 3, path)};
  }
};

GrammarRequest in(const Blocks& blocks, std::string text) {
  return {.text = std::move(text), .parameters = {{"unit", 1000}}, .more = blocks.views()};
}

TEST_CASE("no lateral leaves its area, for areas of any kind, rotation and overlap") {
  const std::string text = topiary();
  const auto unit = [](std::uint64_t stream, std::uint64_t i) { return random_unit(3, stream, i); };
  std::size_t tips = 0, outside = 0, between = 0, reached = 0;
  for (std::uint64_t trial = 0; trial < 40; ++trial) {
    std::vector<Area> areas;
    float top = 0.2f;
    for (std::uint64_t i = 3 * trial; i < 3 * trial + 1 + trial % 3; ++i) {
      Area area;
      area.kind = static_cast<Kind>(static_cast<std::uint32_t>(6 * unit(1, i)));
      area.size = 0.5f + 0.7f * glm::vec3(unit(2, i), unit(3, i), unit(4, i));
      // Each overlaps the one before, where the random value is low.
      top += (0.2f + 0.6f * unit(5, i)) * area.size.y;
      area.centre = {0.6f * unit(6, i) - 0.3f, top, 0.6f * unit(7, i) - 0.3f};
      top += 0.3f * area.size.y;
      const glm::vec3 axis = random_direction(3, 8, i);
      const float half = 3 * unit(9, i);
      area.rotation = glm::quat(std::cos(half), std::sin(half) * axis);
      if (area.kind == Kind::mesh) {
        area.mesh = i % 2 == 0 ? corner() : ellipsoid({0, 0, 0}, {1, 1, 1}, 12);
        if (i % 4 == 1) append(area.mesh, box({0.3f, 0.3f, 0.3f}, {1.4f, 0.9f, 2}));
      }
      areas.push_back(std::move(area));
    }
    const Blocks blocks(areas);
    GrammarRequest request = in(blocks, text);
    request.constants = {{"leaf", 0.14f}};
    request.seed = static_cast<std::uint32_t>(trial + 1);
    const Plant plant = grow(request);
    const auto area = column_in<std::uint8_t>(plant.columns, "segments.area"),
               main = column_in<std::uint8_t>(plant.columns, "segments.main");
    std::vector<Volume> volumes;
    for (const Area& each : areas) volumes.push_back(each.volume());
    std::vector<bool> is_parent(plant.segments.size());
    for (const Segment& segment : plant.segments)
      if (segment.parent >= 0) is_parent[static_cast<std::size_t>(segment.parent)] = true;
    for (std::size_t i = 0; i < plant.segments.size(); ++i) {
      if (main[i] == 1) continue;
      REQUIRE(area[i] >= 1);
      const Volume& volume = volumes[area[i] - 1u];
      const Segment& segment = plant.segments[i];
      if (!is_parent[i]) {
        ++tips;
        outside += volume.contains(segment.end) ? 0 : 1;
      }
      // The whole segment, also where the mesh is concave.
      for (int k = 0; k < 8; ++k)
        between += volume.contains(glm::mix(segment.start, segment.end, static_cast<float>(k) / 8)) ? 0 : 1;
    }
    reached += static_cast<std::size_t>(*std::max_element(area.begin(), area.end()));
  }
  CHECK(tips > 4000);
  CHECK(outside == 0);
  CHECK(between == 0);
  CHECK(reached > 60);
}

TEST_CASE("the main branch ends inside the last area, also where its path leads out of it") {
  for (const std::vector<float>& path : {std::vector<float>{0, 0.9f, 0, 0, 9, 0},
                                         {0, 0.9f, 0, 0.47f, 1.3f, 0},
                                         {0, 0.5f, 0, 0.45f, 0.9f, 0, 0.8f, 0.9f, 0}}) {
    const Area cube{Kind::box, {0, 0.85f, 0}, {1, 1, 1}};
    Blocks blocks({cube});
    blocks.path = path;
    GrammarRequest request = in(blocks, topiary());
    request.constants = {{"leaf", 0.1f}};
    const Plant plant = grow(request);
    const auto main = column_in<std::uint8_t>(plant.columns, "segments.main");
    std::size_t segments = 0;
    glm::vec3 tip(0);
    for (std::size_t i = 0; i < plant.segments.size(); ++i) {
      if (main[i] == 0) continue;
      ++segments;
      tip = plant.segments[i].end;
    }
    CHECK(cube.volume().contains(tip));
    // It grows while there is room for a segment, which is two leaves long.
    CHECK(segments >= 3);
    const glm::vec3 way = glm::normalize(glm::vec3(path[path.size() - 3], path[path.size() - 2], 0) - tip);
    CHECK(cube.volume().reach(tip, way, 1) < 0.2f + 0.2f);
  }
}

TEST_CASE("reach() does not depend on the length of the direction") {
  const std::string text =
      "#input areas\n#input places\n#input path[]\naxiom: F(reach(0,100,0,0,7,0,1,900)) "
      "F(reach(0,100,0,0,0.01,0,1,900)) "
      "F(reach(0,100,0,0,0,0,1,900)+1)\n";
  const Area area{Kind::box, {0, 0.1f, 0}, {1, 0.4f, 1}};
  const Plant plant = grow({.text = text, .parameters = {{"unit", 1}}, .more = Blocks({area}).views()});
  REQUIRE(plant.segments.size() == 3);
  for (const std::size_t i : {0u, 1u})
    CHECK(1000 * glm::distance(plant.segments[i].start, plant.segments[i].end) == doctest::Approx(200).epsilon(1e-4));
  CHECK(1000 * glm::distance(plant.segments[2].start, plant.segments[2].end) == doctest::Approx(1).epsilon(1e-4));
}

TEST_CASE("bound() and reach() use the grammar's unit, for areas in metres") {
  const std::string text =
      "#input areas\n#input places\n#input path[]\naxiom: F(reach(0,0,0,0,1,0,1,900)) "
      "F(bound(0,200,0,1)+bound(0,400,0,1)) "
      "F(bound(0,0,0,2)) F(areas) F(places) F(path[2])\n";
  const Area area{Kind::box, {0, 0.1f, 0}, {1, 0.4f, 1}};
  const Plant plant = grow({.text = text, .parameters = {{"unit", 1}}, .more = Blocks({area}).views()});
  std::vector<double> lengths;
  for (const Segment& segment : plant.segments) lengths.push_back(1000 * glm::distance(segment.start, segment.end));
  REQUIRE(lengths.size() == 5);  // F of length 0 draws no segment
  CHECK(lengths[0] == doctest::Approx(300).epsilon(1e-4));
  CHECK(lengths[1] == doctest::Approx(1).epsilon(1e-4));
  CHECK(lengths[2] == doctest::Approx(1).epsilon(1e-4));
  CHECK(lengths[3] == doctest::Approx(1).epsilon(1e-4));
  CHECK(lengths[4] == doctest::Approx(100).epsilon(1e-4));
}

TEST_CASE("the role of an area holds to the end of its branch") {
  const Plant plant = grow({.text = "#role area Zone\naxiom: F [ Zone(2) F [ Zone(3,1) F ] F ] F Zone(1,1) F\n"});
  CHECK(column_in<std::uint8_t>(plant.columns, "segments.area") == std::vector<std::uint8_t>{0, 2, 3, 2, 0, 1});
  CHECK(column_in<std::uint8_t>(plant.columns, "segments.main") == std::vector<std::uint8_t>{0, 0, 1, 0, 0, 1});
  const Plant plain = grow({.text = "axiom: F F\n"});
  for (std::size_t i = 0; i < plain.columns.size(); ++i) CHECK(plain.columns[i].name != "segments.area");
}

TEST_CASE("notes list areas that the main branch does not reach, and meshes with gaps") {
  Surface open = corner();
  open.triangles.resize(open.triangles.size() - 3);
  const Blocks blocks(
      {{Kind::mesh, {0, 0.6f, 0}, {1, 1, 1}, {1, 0, 0, 0}, open}, {Kind::sphere, {9, 9, 9}, {1, 1, 1}}});
  Blocks led = blocks;
  led.path = {0, 0.6f, 0, 0, 2, 0};
  GrammarRequest request = in(led, topiary());
  request.constants = {{"leaf", 0.2f}};
  const Plant plant = grow(request);
  REQUIRE(plant.notes.size() == 2);
  CHECK(english(plant.notes[0]).find("The mesh of area 1 has holes at 3 edges") == 0);
  CHECK(english(plant.notes[1]).find("Area 2 stays empty, because the main branch does not reach it") == 0);
}

TEST_CASE("a note lists an area within an earlier one, where nothing grows") {
  const Blocks blocks({{Kind::box, {0, 0.6f, 0}, {1, 1, 1}}, {Kind::sphere, {0.1f, 0.6f, 0}, {0.4f, 0.4f, 0.4f}}});
  GrammarRequest request = in(blocks, topiary());
  request.constants = {{"leaf", 0.2f}};
  const Plant plant = grow(request);
  REQUIRE(plant.notes.size() == 1);
  CHECK(english(plant.notes[0]).find("Area 2 stays empty, because its centre is inside area 1") == 0);
}

TEST_CASE("too many queries of triangles are an error, as are too many triangles") {
  const Blocks blocks({{Kind::mesh, {0, 1, 0}, {1, 2, 1}, {1, 0, 0, 0}, spanning_tetrahedra(100)},
                       {Kind::mesh, {0, 3, 0}, {1, 2, 1}, {1, 0, 0, 0}, spanning_tetrahedra(100)}});
  GrammarRequest request = in(blocks, topiary());
  CHECK(try_grow(request));
  request.limits.looks = 10'000;
  const auto stopped = try_grow(request);
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().reason == Reason::limit);
  CHECK(english(stopped.error().message).find("simplify the mesh") != std::string::npos);
  request.limits.triangles = 799;
  const auto refused = try_grow(request);
  REQUIRE_FALSE(refused);
  CHECK(english(refused.error().message) == "The meshes have 800 triangles; the limit is 799. Simplify them.");
}

TEST_CASE("invalid areas are refused with the reason") {
  const auto refused = [](auto change) {
    Blocks blocks({{Kind::mesh, {0, 1, 0}, {1, 1, 1}, {1, 0, 0, 0}, corner()}});
    change(blocks);
    GrammarRequest request = in(blocks, topiary());
    const auto plant = try_grow(request);
    REQUIRE_FALSE(plant);
    return english(plant.error().message);
  };
  CHECK(refused([](Blocks& b) { b.places[3] = NAN; }).find("not a finite number") != std::string::npos);
  CHECK(refused([](Blocks& b) { b.kinds[0] = 6; }).find("unknown kind") != std::string::npos);
  CHECK(refused([](Blocks& b) { b.triangles[4] = 99; }).find("a point that the area does not have") !=
        std::string::npos);
  CHECK(refused([](Blocks& b) { b.meshes[1] = 999; }).find("more points or triangles") != std::string::npos);
  CHECK(refused([](Blocks& b) { b.kinds.push_back(0); }).find("one position for each area") != std::string::npos);
  CHECK(refused([](Blocks& b) { b.path = {1, 2, 3, INFINITY, 0, 0}; }).find("not a finite number") !=
        std::string::npos);
}

TEST_CASE("a topiary without areas is a bare stem") {
  const Plant plant = grow({.text = topiary(), .parameters = {{"unit", 1000}}});
  CHECK(plant.segments.size() > 3);
  CHECK(plant.segments.size() < 20);
}

}  // namespace
}  // namespace panicle::grammar
