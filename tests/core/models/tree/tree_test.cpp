// The tree, requested as the page requests it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/english.hpp"
#include "models/particles/crown_light.hpp"
#include "models/particles/obstacles.hpp"
#include "models/particles/space_growing.hpp"
#include "models/tree/crown.hpp"
#include "models/tree/measures/measures.generated.hpp"
#include "spatial/surfaces.hpp"

namespace panicle::particles {
namespace {

using tree::CrownHabit;
using tree::Measure;

const std::vector<float> wasp{0.1f, 0, 1, 0.2f, 0.15f, 0.5f, 0.9f, 0.8f, 0.1f, 1};

struct Case {
  const char* name;
  Form form;
  std::vector<std::pair<std::string_view, float>> parameters;
  std::vector<float> profile;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"sphere", Form::ellipsoid, {{"shape", 0}}, {}},
      {"ellipsoid", Form::ellipsoid, {{"shape", 1}, {"height", 9}}, {}},
      {"box", Form::box, {{"shape", 2}, {"depth", 3}}, {}},
      {"cone", Form::cone, {{"shape", 3}}, {}},
      {"spline", Form::spline, {{"shape", 4}}, wasp},
  };
  return all;
}

CrownHabit habit_of(const Case& one) {
  CrownHabit habit;
  habit.form = one.form;
  for (const auto& [key, value] : one.parameters) {
    if (key == "height") habit.size.y = value;
    if (key == "depth") habit.size.z = value;
  }
  return habit;
}

std::vector<glm::vec2> profile_points(const std::vector<float>& values) {
  std::vector<glm::vec2> points;
  for (std::size_t i = 0; i + 1 < values.size(); i += 2) points.emplace_back(values[i], values[i + 1]);
  return points;
}

TEST_CASE("runs of every shape and seed end, with all energy at the targets and one tree to each") {
  for (const Case& one : cases())
    for (const std::uint32_t seed : {1u, 2u, 77u})
      for (const float rule : {0.0f, 1.0f}) {
        CAPTURE(one.name);
        CAPTURE(seed);
        SpaceOptions options{.parameters = one.parameters, .seed = seed, .profile = one.profile};
        options.parameters.insert(options.parameters.end(),
                                  {{"particles", 500}, {"rule", rule}, {"energy", 3}, {"stems", rule + 1}});
        const Plant plant = grow_tree(options);
        CHECK(count_of(plant, "particles") > 350);
        check_sound(plant, 3);
      }
}

TEST_CASE("runs with extreme parameters end too") {
  const std::vector<std::vector<std::pair<std::string_view, float>>> odd{
      {{"step", 2}, {"merge", 0.1f}, {"pull", 4}},
      {{"step", 0.05f}, {"merge", 4}, {"pull", 0}},
      {{"neighbourhood", 0.5f}, {"slant", 0}},
      {{"slant", 4}, {"trunk", 0}, {"rule", 1}},
      {{"phototropism", 1}, {"gravitropism", 1}},
      {{"phototropism", -1}, {"gravitropism", -1}},
      {{"crowns", 3}, {"distance", 0}, {"stems", 4}},
      {{"inner", 0.95f}, {"absorption", 20}, {"by_light", 2}},
      {{"width", 0.1f}, {"depth", 60}, {"height", 0.1f}},
      {{"particles", 10}, {"hormone", 1}, {"day", 6}},
  };
  for (std::size_t i = 0; i < odd.size(); ++i) {
    CAPTURE(i);
    SpaceOptions options{.parameters = odd[i]};
    if (i + 1 < odd.size()) options.parameters.push_back({"particles", 300});
    check_sound(grow_tree(options), 1);
  }
}

TEST_CASE("no particle starts inside an inner boundary that is a mesh, and some start where it leaves room") {
  // A box in a box, of which the mesh is the lower half.
  const std::vector<std::pair<std::string_view, float>> parameters{
      {"shape", 2},       {"width", 4},    {"height", 4},  {"depth", 4}, {"trunk", 1},
      {"particles", 900}, {"inner", 0.8f}, {"pattern", 2}, {"life", 0},  {"age", 100}};
  Surface half = box({0, 0, 0}, {1, 1, 1});
  // Two boxes: the upper one is a splinter, so that the mesh is as high as its box.
  append(half, box({0, 1, 0}, {0.01f, 2, 0.01f}));
  const auto above = [](const Plant& plant) {
    std::size_t count = 0;
    for (const std::size_t tip : tips_of(plant)) {
      const glm::vec3& end = plant.segments[tip].end;
      if (std::fabs(end.x) < 1.55f && std::fabs(end.z) < 1.55f && end.y > 3.05f && end.y < 4.5f) ++count;
      if (std::fabs(end.x) < 1.59f && std::fabs(end.z) < 1.59f) CHECK_FALSE((end.y > 1.41f && end.y < 2.99f));
    }
    return count;
  };
  CHECK(above(grow_tree({.parameters = parameters})) == 0);
  CHECK(above(grow_tree({.parameters = parameters, .hollow = half})) > 100);
  // A triangle with a corner that is no point is refused.
  Surface broken = half;
  broken.triangles.back() = 99;
  const std::string refusal = english(request_tree({.parameters = parameters, .hollow = broken}).error().message);
  CHECK(refusal.find("inner boundary") != std::string::npos);
  // An open mesh gets a note.
  Surface open = half;
  open.triangles.resize(open.triangles.size() - 3);
  const Plant gaping = grow_tree({.parameters = parameters, .hollow = open});
  CHECK(english(gaping.notes.back()).find("The inner boundary is open") == 0);
}

TEST_CASE("the light of a crown is listed cell by cell: darker within and below, and full outside") {
  const Plant plant = grow_tree({.parameters = {{"particles", 300},
                                                {"shape", 2},
                                                {"width", 4},
                                                {"height", 4},
                                                {"depth", 4},
                                                {"trunk", 1},
                                                {"sky", 1},
                                                {"absorption", 4}},
                                 .outputs = "light"});
  const auto counts = column_in<std::uint32_t>(plant.columns, "light.counts");
  const auto where = column_in<float>(plant.columns, "light.box");
  const auto cells = column_in<std::uint8_t>(plant.columns, "light.cells");
  REQUIRE(counts.size() == 3);
  REQUIRE(where.size() == 4);
  REQUIRE(cells.size() == std::size_t{counts[0]} * counts[1] * counts[2]);
  CHECK(where[1] < 1.01f);
  CHECK(where[1] + where[3] * static_cast<float>(counts[1]) >= 5);
  const auto at = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return int{cells[(std::size_t{z} * counts[1] + y) * counts[0] + x]};
  };
  const std::uint32_t x = counts[0] / 2, z = counts[2] / 2, top = counts[1] - 2;
  CHECK(at(x, top, z) > 200);
  // The shadow on the floor is darker in the centre than at the edge (section 4.2).
  CHECK(at(x, 1, z) < at(1, 1, z) - 10);
  for (std::uint32_t y = 2; y < top; ++y) CHECK(at(x, y, z) <= at(x, y + 1, z) + 1);
  // Only if requested.
  const Plant without = grow_tree({.parameters = {{"particles", 100}}});
  for (std::size_t i = 0; i < without.columns.size(); ++i) CHECK(without.columns[i].name.find("light") != 0);
  CHECK(without.fingerprint == grow_tree({.parameters = {{"particles", 100}}, .outputs = "light"}).fingerprint);
}

TEST_CASE(
    "no particle starts outside the outer or inside the inner boundary, and trails leave the outer downwards alone") {
  for (const Case& one : cases())
    for (const float pattern : {0.0f, 1.0f, 2.0f, 3.0f}) {
      CAPTURE(one.name);
      CAPTURE(pattern);
      // Limbs that start level and bend up: through the crown's top, were it open.
      SpaceOptions options{.parameters = one.parameters, .profile = one.profile};
      options.parameters.insert(
          options.parameters.end(),
          {{"particles", 700}, {"pattern", pattern}, {"gravitropism", 1}, {"slant", 0.1f}, {"pull", 0.1f}});
      const Plant plant = grow_tree(options);
      const auto crowns = tree::make_crowns(habit_of(one), spline_through(profile_points(one.profile)), {});
      for (const std::size_t tip : tips_of(plant)) {
        CHECK(crowns.outer.contains(plant.segments[tip].end));
        CHECK_FALSE(crowns.inner.contains(plant.segments[tip].end));
      }
      // Branches that left it are partly above.
      const float height = crowns.outer.high().y;
      std::size_t above = 0;
      for (const Segment& segment : plant.segments) {
        float over = segment.end.y;
        while (over < height && !crowns.outer.contains({segment.end.x, over, segment.end.z})) over += 0.01f;
        above += over >= height;
      }
      CHECK(above == 0);
    }
}

TEST_CASE("the uniform pattern has exactly the requested number of particles, the others about as many") {
  for (const float pattern : {0.0f, 1.0f, 2.0f, 3.0f}) {
    const auto count = count_of(grow_tree({.parameters = {{"pattern", pattern}, {"particles", 2000}}}), "particles");
    if (pattern == 0) CHECK(count == 2000);
    CHECK(count > 1800);
    CHECK(count < 2400);  // of blue noise more where a shell is thin
  }
}

TEST_CASE("each particle goes to the nearest target") {
  const Plant plant = grow_tree({.parameters = {{"particles", 600}}, .targets = {-1, 0, 0, 1, 0, 0, 0, 0, 1.5f}});
  check_sound(plant, 1);
  const std::vector<glm::vec3> targets{{-1, 0, 0}, {1, 0, 0}, {0, 0, 1.5f}};
  std::vector<std::int32_t> root(plant.segments.size());
  for (std::size_t i = 0; i < plant.segments.size(); ++i)
    root[i] = plant.segments[i].parent < 0 ? static_cast<std::int32_t>(i)
                                           : root[static_cast<std::size_t>(plant.segments[i].parent)];
  for (const std::size_t tip : tips_of(plant)) {
    const glm::vec3 p = plant.segments[tip].end, mine = plant.segments[static_cast<std::size_t>(root[tip])].start;
    for (const glm::vec3& other : targets) CHECK(glm::distance(p, mine) <= glm::distance(p, other) + 1e-5f);
  }
  // A hedge: stems in a row along the width.
  const Plant hedge =
      grow_tree({.parameters = {{"shape", 2}, {"width", 8}, {"depth", 1}, {"stems", 4}, {"particles", 800}}});
  CHECK(column_in<float>(hedge, "targets.places") == std::vector<float>{-3, 0, 0, -1, 0, 0, 1, 0, 0, 3, 0, 0});
  check_sound(hedge, 1);
}

namespace {

// Number of tips of each crown of a row, and of those at its left and in its lower half.
struct Tips {
  double all = 0, left = 0, low = 0;
};

std::vector<Tips> tips_by_crown(std::uint32_t crowns, float gap, float particles, Plant* plant = nullptr) {
  Plant row = grow_tree({.parameters = {{"crowns", static_cast<float>(crowns)},
                                        {"distance", gap},
                                        {"particles", particles},
                                        {"sky", 1},
                                        {"inner", 0},
                                        {"absorption", 6}},
                         .outputs = "measures"});
  std::vector<Tips> tips(crowns);
  for (const std::size_t tip : tips_of(row)) {
    const glm::vec3& p = row.segments[tip].end;
    const float x = p.x / gap + 0.5f * static_cast<float>(crowns - 1);
    const float which = std::clamp(std::round(x), 0.0f, static_cast<float>(crowns - 1));
    Tips& crown = tips[static_cast<std::size_t>(which)];
    ++crown.all;
    crown.left += x < which;
    crown.low += p.y < 5;
  }
  if (plant) *plant = std::move(row);
  return tips;
}

}  // namespace

TEST_CASE("crowns far apart are lit and as large as one alone; side by side they shade each other, evenly") {
  Plant lone;
  const Tips alone = tips_by_crown(1, 1000, 3000, &lone)[0];
  CHECK(alone.low < 0.35 * alone.all);
  for (const std::uint32_t crowns : {2u, 5u, 12u}) {
    CAPTURE(crowns);
    Plant row;
    for (const Tips& crown : tips_by_crown(crowns, 60, 3000 * static_cast<float>(crowns), &row)) {
      CHECK(crown.all == doctest::Approx(3000).epsilon(0.04));
      CHECK(crown.left == doctest::Approx(0.5 * crown.all).epsilon(0.06));
      CHECK(std::fabs(crown.low / crown.all - alone.low / alone.all) < 0.03);
    }
    const auto volume = [](const Plant& plant) {
      return plant.measures[static_cast<std::size_t>(Measure::crown_volume)];
    };
    CHECK(volume(row) == doctest::Approx(static_cast<float>(crowns) * volume(lone)).epsilon(0.02));
  }
  const std::vector<Tips> close = tips_by_crown(12, 6, 20000);
  double inner = 0;
  for (std::size_t i = 2; i < 10; ++i) inner += close[i].all / 8;
  for (std::size_t i = 2; i < 10; ++i) CHECK(std::fabs(close[i].all / inner - 1) < 0.05);
  CHECK(close[0].all > 1.03 * inner);
  CHECK(close[0].left > 1.05 * (close[0].all - close[0].left));
}

TEST_CASE("crowns too far apart for their size to be lit finely get a note") {
  const auto row = [](float width) {
    return grow_tree({.parameters = {{"crowns", 12},
                                     {"distance", 60},
                                     {"width", width},
                                     {"height", width},
                                     {"depth", width},
                                     {"particles", 200}}});
  };
  CHECK(row(6).notes.empty());
  CHECK(has_note(row(0.2f), "light is computed coarsely"));
}

TEST_CASE("no particle starts in an obstacle, and no trail passes it") {
  const std::vector<float> wall{0.8f, 0, -2.5f, 1.1f, 6, 2.5f, -2, 3, -2, -1.5f, 5, 2};
  const Plant plant = grow_tree({.parameters = {{"particles", 1500}, {"inner", 0.3f}}, .obstacles = wall});
  check_sound(plant, 1);
  const std::vector<Box> boxes{{{0.8f, 0, -2.5f}, {1.1f, 6, 2.5f}}, {{-2, 3, -2}, {-1.5f, 5, 2}}};
  const Obstacles obstacles(boxes, 0, 0, 100);
  for (const Segment& segment : plant.segments) CHECK_FALSE(obstacles.between(segment.start, segment.end));
  const Plant open = grow_tree({.parameters = {{"particles", 1500}, {"inner", 0.3f}}});
  std::uint32_t crossing = 0;
  for (const Segment& segment : open.segments) crossing += obstacles.between(segment.start, segment.end);
  CHECK(crossing > 20);
}

TEST_CASE("another tree's crown is round: no particle starts in it, no trail passes it, and it takes light") {
  // Beside the crown, which reaches to 3 m, and into it.
  const std::vector<float> neighbour{1.5f, 3, -2.5f, 6.5f, 9, 2.5f};
  const SpaceOptions options{.parameters = {{"particles", 2500}, {"inner", 0.3f}, {"absorption", 6}}};
  const Plant open = grow_tree(options);
  SpaceOptions beside = options;
  beside.rounds = neighbour;
  const Plant plant = grow_tree(beside);
  check_sound(plant, 1);
  const std::vector<Box> rounds{{{1.5f, 3, -2.5f}, {6.5f, 9, 2.5f}}};
  const Obstacles obstacles({}, rounds, 0, 0, 100);
  for (const Segment& segment : plant.segments) CHECK_FALSE(obstacles.between(segment.start, segment.end));
  std::uint32_t crossing = 0;
  for (const Segment& segment : open.segments) crossing += obstacles.between(segment.start, segment.end);
  CHECK(crossing > 20);
  // A corner of its box is free.
  CHECK_FALSE(obstacles.contains({1.6f, 3.1f, -2.4f}));
  CHECK(obstacles.contains({1.6f, 6, 0}));

  const auto halves = [](const std::vector<Box>& others) {
    CrownHabit habit;
    const auto crowns = tree::make_crowns(habit, {}, {});
    const VoxelLight light = light_in(crowns.outer, {others, {}}, {.sky = 1, .absorption = 1}, 6.0f / 28);
    return light.at({1.2f, 5, 0}) / light.at({-1.2f, 5, 0});
  };
  CHECK(halves({}) == doctest::Approx(1).epsilon(0.05));
  CHECK(halves({{{2, 1, -4}, {10, 11, 4}}}) < 0.8f);
  const std::string refusal = english(request_tree({.rounds = {0, 0, 0, 1, 1}}).error().message);
  CHECK(refusal == "Round obstacles need 6 numbers each.");
}

TEST_CASE("a dropped mesh is the crown; an open one gets a note, a missing one is an ellipsoid") {
  const Surface cube = box({5, 5, 5}, {7, 9, 7});
  SpaceOptions options{
      .parameters = {{"shape", 5}, {"particles", 500}, {"inner", 0}, {"width", 4}, {"height", 2}, {"depth", 3}}};
  for (const glm::vec3& p : cube.points) options.points.insert(options.points.end(), {p.x, p.y, p.z});
  options.triangles = cube.triangles;
  const Plant plant = grow_tree(options);
  CHECK(plant.notes.empty());
  check_sound(plant, 1);
  glm::vec3 high(-100);
  for (const std::size_t tip : tips_of(plant)) {
    const glm::vec3 p = plant.segments[tip].end;
    CHECK(std::fabs(p.x) <= 2);
    CHECK(std::fabs(p.z) <= 1.5f);
    high = glm::max(high, p);
  }
  CHECK(high.x > 1.8f);
  CHECK(high.y > 3.8f);
  options.triangles.resize(options.triangles.size() - 3);
  CHECK(has_note(grow_tree(options), "open at 3 edges"));
  CHECK(has_note(grow_tree({.parameters = {{"shape", 5}, {"particles", 50}}}), "no mesh"));
}

TEST_CASE("requests beyond the limits of segments or leaves are refused, with a fix") {
  const auto refusal = [](Result<Plant> plant) {
    REQUIRE_FALSE(plant);
    CHECK(plant.error().reason == Reason::limit);
    return english(plant.error().message);
  };
  const auto options = [](std::uint32_t trails, std::uint32_t leaves) {
    SpaceOptions each{.parameters = {{"particles", 300}}};
    each.limits.pieces = trails;
    each.limits.copies = leaves;
    return each;
  };
  const Plant usual = grow_tree(options(2000, 2000));
  const auto segments = static_cast<std::uint32_t>(usual.segments.size()), leaves = count_of(usual, "leaves");
  CHECK(grow_tree(options(segments, leaves)).fingerprint == usual.fingerprint);
  CHECK(refusal(request_tree(options(segments - 1, leaves))) ==
        "The plant would have " + std::to_string(segments) + " pieces of branches, roots or veins; the limit is " +
            std::to_string(segments - 1) + ". Use fewer particles.");
  CHECK(refusal(request_tree(options(segments, leaves - 1))).find("fewer leaves on each tip") != std::string::npos);
  CHECK(refusal(request_root(options(100, 0))).find("the limit is 100.") != std::string::npos);
}

TEST_CASE("runs that are too long are stopped, and too many leaves are refused before") {
  SpaceOptions slow{.parameters = {{"particles", 300}, {"step", 0.05f}, {"merge", 0.1f}, {"pull", 0}, {"stems", 3}}};
  slow.limits.moves = 1'000'000;
  const Plant plant = grow_tree(slow);
  CHECK(plant.segments.size() > 300);
  slow.limits.moves = 5000;
  const std::string words =
      "Particles are still moving after 5000 moves; use fewer particles, a longer step or a larger merge radius.";
  for (const auto& refused : {request_tree(slow), request_root(slow)}) {
    REQUIRE_FALSE(refused);
    CHECK(refused.error().reason == Reason::limit);
    CHECK(english(refused.error().message) == words);
  }
  // Refused before particles move.
  SpaceOptions leafy{.parameters = {{"particles", 1000}, {"leaves", 6}}};
  leafy.limits.moves = 0;
  leafy.limits.copies = 5999;
  CHECK(english(request_tree(leafy).error().message).find("6000 leaves; the limit is 5999") != std::string::npos);
  // A small tree has fewer.
  leafy.parameters.insert(leafy.parameters.end(), {{"life", 1}, {"age", 50}});
  CHECK(english(request_tree(leafy).error().message).starts_with("Particles are still moving after 0 moves"));
}

TEST_CASE("targets in the crown or above it are reached upwards, with a note") {
  const auto notes_of = [](float target) {
    return grow_tree({.parameters = {{"particles", 100}}, .targets = {0, target, 0, 1, 0, 0}}).notes;
  };
  CHECK(notes_of(1.9f).empty());
  const std::vector<std::string> notes = notes_of(20);
  REQUIRE(notes.size() == 1);
  CHECK(english(notes[0]).find("1 target is above the lowest point of the boundary") == 0);
  const Plant root = grow_root({.parameters = {{"particles", 100}}, .targets = {0, -1, 0, 1, 0.5f, 0}});
  REQUIRE(root.notes.size() == 1);
  CHECK(english(root.notes[0]).find("1 target is below the highest point of the boundary") == 0);
}

TEST_CASE("a merge radius that would not end is raised, with a note") {
  const auto notes_of = [](float merge, float pull) {
    return grow_tree({.parameters = {{"particles", 100}, {"step", 0.5f}, {"merge", merge}, {"pull", pull}}}).notes;
  };
  CHECK(notes_of(0.5f, 1).empty());
  CHECK(notes_of(0.1f, 0).empty());
  const std::vector<std::string> notes = notes_of(0.45f, 1);
  REQUIRE(notes.size() == 1);
  CHECK(english(notes[0]).find("raised to 50 % of the particle spacing") != std::string::npos);
}

TEST_CASE("a run without particles gets a note with the reason") {
  const auto notes_of = [](const SpaceOptions& options) {
    const Plant plant = grow_tree(options);
    CHECK(plant.segments.empty());
    REQUIRE(plant.notes.size() == 1);
    return english(plant.notes[0]);
  };
  CHECK(notes_of({.parameters = {{"shape", 4}}, .profile = {0, 0, 0, 1}}).find("The boundary encloses no space") == 0);
  CHECK(notes_of({.parameters = {{"life", 1}, {"age", 0}}}).find("At this age") == 0);
  CHECK(notes_of({.parameters = {{"sky", 0}, {"sun", 90}, {"sun_height", 0}}, .obstacles = {4, -9, -50, 50, 50, 50}})
            .find("No particle can start") == 0);
}

TEST_CASE("invalid inputs are refused with a message, numbers out of range are clamped") {
  const auto refusal = [](const SpaceOptions& options) {
    const Result<Plant> plant = request_tree(options);
    REQUIRE_FALSE(plant);
    return english(plant.error().message);
  };
  CHECK(refusal({.targets = {0, NAN, 0}}).find("Target 1 is out of range: number 2 in this entry is not finite") !=
        std::string::npos);
  CHECK(refusal({.targets = {0, 0}}).find("3 numbers each") != std::string::npos);
  CHECK(refusal({.targets = std::vector<float>(3 * 257, 1)}).find("use at most 256") != std::string::npos);
  CHECK(refusal({.obstacles = std::vector<float>(6 * 17, 1)}).find("use at most 16") != std::string::npos);
  CHECK(refusal({.obstacles = {0, 0, 0, 1, 1e30f, 1}}).find("Obstacle 1 is out of range: number 5") !=
        std::string::npos);
  CHECK(refusal({.profile = {1, 2, 3}}).find("2 numbers each") != std::string::npos);
  CHECK(refusal({.points = {0, 0, 0}, .triangles = {0, 0, 1}}).find("point 1") != std::string::npos);
  CHECK(refusal({.points = {0, 0, 0}, .triangles = {0, 0}}).find("3 corners") != std::string::npos);
  const Plant plant = grow_tree({.parameters = {{"particles", 3}, {"width", 1e9f}, {"height", -5}}});
  CHECK(has_note(plant, "Parameter particles was out of range and was set to the nearest allowed value."));
  CHECK(has_note(plant, "Parameter width was out of range"));
  CHECK(has_note(plant, "Parameter height was out of range"));
  const Plant nowhere =
      grow_tree({.parameters = {{"particles", 100}, {"pattern", 1}}, .obstacles = {-50, -1, -50, 50, 50, 50}});
  CHECK(has_note(nowhere, "The obstacles leave no space"));
  CHECK(nowhere.segments.empty());
}

TEST_CASE("a mesh whose triangles lie behind each other too often is an error, as is one of too many triangles") {
  const Surface mesh = spanning_tetrahedra(100);
  SpaceOptions options{.parameters = {{"particles", 200}, {"shape", 5}}, .triangles = mesh.triangles};
  for (const glm::vec3& p : mesh.points) options.points.insert(options.points.end(), {p.x, p.y, p.z});
  CHECK(request_tree(options));
  options.limits.looks = 1'000'000;
  const Result<Plant> stopped = request_tree(options);
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().reason == Reason::limit);
  CHECK(english(stopped.error().message).find("simplify the mesh") != std::string::npos);
  options.limits.triangles = 399;
  const Result<Plant> refused = request_tree(options);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().reason == Reason::limit);
  CHECK(english(refused.error().message) == "The meshes have 400 triangles; the limit is 399. Simplify them.");
}

}  // namespace
}  // namespace panicle::particles
