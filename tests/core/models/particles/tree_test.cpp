// The tree, asked as the page asks it.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "models/particles/crown_light.hpp"
#include "models/particles/obstacles.hpp"
#include "models/particles/tree/crown.hpp"
#include "models/particles/tree/measures/measures.generated.hpp"
#include "space_growing.hpp"

namespace panicle::particles {
namespace {

using tree::CrownHabit;
using tree::Measure;

float measure(const Plant& plant, Measure which) { return plant.measures[static_cast<std::size_t>(which)]; }

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

// Every tree has these, whatever was asked.
void check_sound(const Plant& plant, double energy) {
  const auto energies = column_in<float>(plant, "segments.energy");
  const auto arrived = column_in<float>(plant, "targets.energy");
  REQUIRE(energies.size() == plant.segments.size());
  double sum = 0, at_targets = 0;
  for (const float each : arrived) sum += static_cast<double>(each);
  std::vector<double> inflow(plant.segments.size(), 0);
  for (std::size_t i = 0; i < plant.segments.size(); ++i) {
    const Segment& segment = plant.segments[i];
    CHECK(segment.parent < static_cast<std::int32_t>(i));
    CHECK(segment.radius > 0);
    if (segment.parent >= 0) {
      CHECK(plant.segments[static_cast<std::size_t>(segment.parent)].end == segment.start);
      inflow[static_cast<std::size_t>(segment.parent)] += static_cast<double>(energies[i]);
    } else {
      at_targets += static_cast<double>(energies[i]);
    }
  }
  // Whole energies below 2^24 add up exactly.
  CHECK(at_targets == sum);
  CHECK(sum == energy * count_of(plant, "particles"));
  CHECK(count_of(plant, "energy") == static_cast<std::uint32_t>(sum));
  for (std::size_t i = 0; i < inflow.size(); ++i)
    if (inflow[i] > 0) CHECK(inflow[i] <= static_cast<double>(energies[i]));
  // One tree a target, whose ends are the particles.
  CHECK(tips_of(plant).size() == count_of(plant, "particles"));
  const auto places = column_in<float>(plant, "targets.places");
  CHECK(places.size() == 3 * count_of(plant, "targets"));
  for (const Segment& segment : plant.segments) {
    if (segment.parent >= 0) continue;
    bool at_target = false;
    for (std::size_t k = 0; k < places.size(); k += 3)
      at_target = at_target || segment.start == glm::vec3(places[k], places[k + 1], places[k + 2]);
    CHECK(at_target);
  }
}

TEST_CASE("for every shape and seed it ends, with all energy at the targets and one tree to each") {
  for (const Case& one : cases())
    for (const std::uint32_t seed : {1u, 2u, 77u})
      for (const float rule : {0.0f, 1.0f}) {
        CAPTURE(one.name);
        CAPTURE(seed);
        Asked asked{.parameters = one.parameters, .seed = seed, .profile = one.profile};
        asked.parameters.insert(asked.parameters.end(),
                                {{"particles", 500}, {"rule", rule}, {"energy", 3}, {"stems", rule + 1}});
        const Plant plant = grow_tree(asked);
        CHECK(count_of(plant, "particles") > 350);
        check_sound(plant, 3);
      }
}

TEST_CASE("odd numbers end too") {
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
    Asked asked{.parameters = odd[i]};
    if (i + 1 < odd.size()) asked.parameters.push_back({"particles", 300});
    check_sound(grow_tree(asked), 1);
  }
}

TEST_CASE("nothing starts outside the outer or inside the inner boundary, and trails leave the outer downwards alone") {
  for (const Case& one : cases())
    for (const float pattern : {0.0f, 1.0f, 2.0f, 3.0f}) {
      CAPTURE(one.name);
      CAPTURE(pattern);
      Asked asked{.parameters = one.parameters, .profile = one.profile};
      asked.parameters.insert(asked.parameters.end(),
                              {{"particles", 700}, {"pattern", pattern}, {"gravitropism", 0.5f}});
      const Plant plant = grow_tree(asked);
      const auto crowns = tree::make_crowns(habit_of(one), spline_through(profile_points(one.profile)), {});
      for (const std::size_t tip : tips_of(plant)) {
        CHECK(crowns.outer.contains(plant.segments[tip].end));
        CHECK_FALSE(crowns.inner.contains(plant.segments[tip].end));
      }
      // A trail is drawn less jagged than it was run, and may be off by that: half of a spacing, about.
      const float spacing = std::cbrt(6 * 6 * 6 * 0.5f / 700);
      for (const Segment& segment : plant.segments)
        if (!crowns.outer.contains(segment.end) && !crowns.outer.contains(segment.start))
          CHECK(segment.start.y <= segment.end.y + 0.5f * spacing);
    }
}

TEST_CASE("the uniform pattern has as many particles as were asked for, the others about as many") {
  for (const float pattern : {0.0f, 1.0f, 2.0f, 3.0f}) {
    const auto count = count_of(grow_tree({.parameters = {{"pattern", pattern}, {"particles", 2000}}}), "particles");
    if (pattern == 0) CHECK(count == 2000);
    CHECK(count > 1800);
    CHECK(count < 2400);  // of blue noise more where a shell is thin
  }
}

TEST_CASE("under a sky, the lower facing halves of twins hold at most 0.8 of the outer ones' particles") {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const auto halves = [seed](float heed) {
      const Plant plant = grow_tree(
          {.parameters =
               {{"crowns", 2}, {"distance", 6}, {"sky", 1}, {"absorption", 5}, {"by_light", heed}, {"particles", 4000}},
           .seed = seed});
      std::uint32_t facing = 0, outer = 0;
      for (const std::size_t tip : tips_of(plant)) {
        const glm::vec3 p = plant.segments[tip].end;
        if (p.y > 5) continue;  // crowns reach from 2 to 8 m
        ++(std::fabs(p.x) < 3 ? facing : outer);
      }
      return static_cast<float>(facing) / static_cast<float>(outer);
    };
    CHECK(halves(1) <= 0.8f);
    CHECK(halves(0) > 0.93f);
  }
}

TEST_CASE("particles gather on the side of the sun") {
  const auto share = [](float bearing) {
    const Plant plant =
        grow_tree({.parameters = {{"sun", bearing}, {"sun_height", 20}, {"sky", 0.2f}, {"particles", 2000}}});
    float sum = 0;
    for (const std::size_t tip : tips_of(plant)) sum += plant.segments[tip].end.x;
    return sum / static_cast<float>(tips_of(plant).size());
  };
  CHECK(share(90) > 0.3f);
  CHECK(share(270) < -0.3f);
  CHECK(std::fabs(share(0)) < 0.15f);
}

// The mean direction that twigs have at their ends.
glm::vec3 twigs_of(const Plant& plant) {
  glm::vec3 sum(0);
  for (const std::size_t tip : tips_of(plant)) {
    // From where the branch is that carries it, a metre from there.
    std::size_t at = tip;
    const glm::vec3 end = plant.segments[tip].end;
    while (glm::distance(plant.segments[at].start, end) < 1 && plant.segments[at].parent >= 0)
      at = static_cast<std::size_t>(plant.segments[at].parent);
    sum += glm::normalize(end - plant.segments[at].start);
  }
  return sum / static_cast<float>(tips_of(plant).size());
}

TEST_CASE("tips bend down or up by gravitropism, towards or away from the light by phototropism") {
  const auto twigs = [](std::string_view which, float much) {
    return twigs_of(grow_tree(
        {.parameters = {
             {which, much}, {"particles", 1500}, {"sun", 90}, {"sun_height", 10}, {"sky", 0}, {"pattern", 2}}}));
  };
  const glm::vec3 plain = twigs("gravitropism", 0);
  CHECK(twigs("gravitropism", 0.8f).y < plain.y - 0.1f);
  CHECK(twigs("gravitropism", -0.8f).y > plain.y + 0.1f);
  CHECK(twigs("phototropism", 0.8f).x > plain.x + 0.1f);
  CHECK(twigs("phototropism", -0.8f).x < plain.x - 0.1f);
}

TEST_CASE("short days end the growth of shoots and make leaves fall") {
  const auto grown = [](float day) {
    return grow_tree({.parameters = {{"day", day}, {"particles", 1000}}, .outputs = "measures"});
  };
  const Plant summer = grown(16), autumn = grown(11), winter = grown(8);
  CHECK(measure(grown(14), Measure::height) == measure(summer, Measure::height));
  CHECK(measure(autumn, Measure::height) < measure(summer, Measure::height) - 0.2f);
  CHECK(measure(winter, Measure::height) < measure(autumn, Measure::height));
  CHECK(count_of(summer, "leaves") == 2 * count_of(summer, "particles"));
  CHECK(count_of(autumn, "leaves") < 0.9f * static_cast<float>(2 * count_of(autumn, "particles")));
  CHECK(count_of(autumn, "leaves") > 0.4f * static_cast<float>(2 * count_of(autumn, "particles")));
  CHECK(count_of(winter, "leaves") == 0);
  CHECK(measure(winter, Measure::leaf_area) == 0);
}

TEST_CASE("apical dominance keeps side branches below the top from growing, and not the leader") {
  const auto top = [](float hormone) {
    const Plant plant =
        grow_tree({.parameters = {{"hormone", hormone}, {"particles", 4000}, {"pattern", 2}, {"inner", 0}}});
    std::uint32_t high = 0, low = 0, leader = 0;
    for (const std::size_t tip : tips_of(plant)) {
      const glm::vec3 p = plant.segments[tip].end;
      const bool aside = p.x * p.x + p.z * p.z > 0.4f * 0.4f;
      if (aside) ++(p.y > 6 ? high : low);
      if (!aside && p.y > 6) ++leader;
    }
    return std::pair(static_cast<float>(high) / static_cast<float>(low), leader);
  };
  const auto [free, free_leader] = top(0);
  const auto [held, held_leader] = top(1);
  CHECK(held < 0.6f * free);
  CHECK(held_leader > 0);
}

TEST_CASE("age: what has grown stays, thickens, and ends as the whole tree") {
  const auto at = [](float age) { return grow_tree({.parameters = {{"age", age}, {"particles", 800}}}); };
  const auto key = [](const Segment& s) {
    return std::array{s.start.x, s.start.y, s.start.z, s.end.x, s.end.y, s.end.z};
  };
  std::map<std::array<float, 6>, float> before;
  for (const float age : {0.0f, 10.0f, 35.0f, 60.0f, 90.0f, 100.0f}) {
    const Plant plant = at(age);
    CAPTURE(age);
    std::map<std::array<float, 6>, float> now;
    for (const Segment& segment : plant.segments) now[key(segment)] = segment.radius;
    for (const auto& [place, radius] : before) {
      const auto found = now.find(place);
      REQUIRE(found != now.end());
      CHECK(found->second >= radius);
    }
    CHECK((age == 0 ? now.empty() : now.size() > before.size()));
    std::uint32_t on_their_way = 0;
    for (const Organ& organ : plant.organs) on_their_way += organ.tag == 1;
    const auto arrived = column_in<float>(plant, "targets.energy");
    if (age == 0) CHECK(on_their_way == count_of(plant, "particles"));
    if (age == 100) CHECK(on_their_way == 0);
    if (age == 35) CHECK(on_their_way > 1);
    CHECK((arrived[0] == static_cast<float>(count_of(plant, "particles"))) == (age == 100));
    before = std::move(now);
  }
}

TEST_CASE("where the boundary grows, a young tree is a small tree, whose twigs start where they will") {
  const auto at = [](float age) {
    return grow_tree({.parameters = {{"life", 1}, {"age", age}, {"particles", 3000}, {"pattern", 2}, {"inner", 0}},
                      .outputs = "measures"});
  };
  const Plant young = at(40), grown = at(100);
  CHECK(measure(young, Measure::height) == doctest::Approx(0.4f * measure(grown, Measure::height)).epsilon(0.03));
  CHECK(measure(young, Measure::crown_volume) ==
        doctest::Approx(0.064f * measure(grown, Measure::crown_volume)).epsilon(0.02));
  const float share =
      static_cast<float>(count_of(young, "particles")) / static_cast<float>(count_of(grown, "particles"));
  CHECK(share == doctest::Approx(0.064f).epsilon(0.25));
  CHECK(measure(young, Measure::trunk_width) == doctest::Approx(0.4f * measure(grown, Measure::trunk_width)));
  check_sound(young, 1);
  check_sound(at(0), 1);
  // A little more age, and most of the starts are where they were.
  const Plant old = at(80), older = at(81);
  const std::vector<std::size_t> others = tips_of(older);
  std::size_t same = 0;
  for (const std::size_t tip : tips_of(old)) {
    const glm::vec3 p = old.segments[tip].end;
    for (const std::size_t other : others)
      if (glm::distance(older.segments[other].end, p) < 0.01f) {
        ++same;
        break;
      }
  }
  CHECK(same > tips_of(old).size() / 3);
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

TEST_CASE("a dropped mesh is the crown; an open one is noted, none is an ellipsoid") {
  const Surface cube = box({5, 5, 5}, {7, 9, 7});
  Asked asked{
      .parameters = {{"shape", 5}, {"particles", 500}, {"inner", 0}, {"width", 4}, {"height", 2}, {"depth", 3}}};
  for (const glm::vec3& p : cube.points) asked.points.insert(asked.points.end(), {p.x, p.y, p.z});
  asked.triangles = cube.triangles;
  const Plant plant = grow_tree(asked);
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
  asked.triangles.resize(asked.triangles.size() - 3);
  CHECK(notes_say(grow_tree(asked), "open at 3 edges"));
  CHECK(notes_say(grow_tree({.parameters = {{"shape", 5}, {"particles", 50}}}), "no mesh"));
}

TEST_CASE("what cannot be used is refused in words, what is out of range is brought into it") {
  const auto refusal = [](const Asked& asked) {
    const Result<Plant> plant = ask_tree(asked);
    REQUIRE_FALSE(plant);
    return plant.error().message;
  };
  CHECK(refusal({.targets = {0, NAN, 0}}).find("Targets: number 2 of row 1 is not finite") != std::string::npos);
  CHECK(refusal({.targets = {0, 0}}).find("3 numbers each") != std::string::npos);
  CHECK(refusal({.targets = std::vector<float>(3 * 257, 1)}).find("no more than 256 targets") != std::string::npos);
  CHECK(refusal({.obstacles = std::vector<float>(6 * 17, 1)}).find("no more than 16 obstacles") != std::string::npos);
  CHECK(refusal({.obstacles = {0, 0, 0, 1, 1e30f, 1}}).find("number 5 of row 1") != std::string::npos);
  CHECK(refusal({.profile = {1, 2, 3}}).find("2 numbers each") != std::string::npos);
  CHECK(refusal({.points = {0, 0, 0}, .triangles = {0, 0, 1}}).find("corner 1") != std::string::npos);
  CHECK(refusal({.points = {0, 0, 0}, .triangles = {0, 0}}).find("3 corners") != std::string::npos);
  const Plant plant = grow_tree({.parameters = {{"particles", 3}, {"width", 1e9f}, {"height", -5}}});
  CHECK(notes_say(plant, "Parameter particles was brought into its range."));
  CHECK(notes_say(plant, "Parameter width was brought"));
  CHECK(notes_say(plant, "Parameter height was brought"));
  const Plant nowhere = grow_tree({.parameters = {{"particles", 100}}, .obstacles = {-50, -1, -50, 50, 50, 50}});
  CHECK(notes_say(nowhere, "No particle found room"));
  CHECK(nowhere.segments.empty());
}

TEST_CASE("meshes: tubes of bark along the branches, leaves and balls as organs that share a mesh each") {
  const Plant plant = grow_tree({.parameters = {{"particles", 400}, {"age", 50}}, .outputs = "meshes sky"});
  REQUIRE(plant.meshes.size() == 3);
  CHECK(plant.meshes[0].material == "bark");
  CHECK(plant.meshes[1].material == "blade");
  const Mesh& stems = plant.meshes[0].mesh;
  for (const std::uint32_t index : stems.indices) CHECK(index < stems.positions.size() / 3);
  for (const float value : stems.positions) CHECK(std::isfinite(value));
  for (std::size_t v = 0; v + 2 < stems.normals.size(); v += 3)
    CHECK(std::hypot(stems.normals[v], stems.normals[v + 1], stems.normals[v + 2]) == doctest::Approx(1).epsilon(1e-3));
  CHECK(column_in<std::uint8_t>(plant, "organs.sky").size() == plant.organs.size());
  for (const Organ& organ : plant.organs)
    CHECK(plant.meshes[static_cast<std::size_t>(organ.mesh)].name == (organ.tag == 0 ? "leaves" : "balls"));
  CHECK(grow_tree({.parameters = {{"particles", 400}}}).meshes.empty());
}

TEST_CASE("meshes are there for what is borne, and for nothing else") {
  const auto names = [](std::initializer_list<std::pair<std::string_view, float>> more) {
    std::vector<std::pair<std::string_view, float>> parameters{{"particles", 200}};
    parameters.insert(parameters.end(), more);
    std::vector<std::string> found;
    for (const PlantMesh& each : grow_tree({.parameters = parameters, .outputs = "meshes"}).meshes)
      found.push_back(each.name);
    return found;
  };
  CHECK(names({}) == std::vector<std::string>{"stems", "leaves"});
  CHECK(names({{"leaves", 0}}) == std::vector<std::string>{"stems"});
  CHECK(names({{"leaves", 0}, {"age", 50}}) == std::vector<std::string>{"stems", "balls"});
  CHECK(names({{"age", 50}}) == std::vector<std::string>{"stems", "leaves", "balls"});
}

TEST_CASE("the sky is darker inside a crown than on it") {
  const Plant plant =
      grow_tree({.parameters = {{"particles", 3000}, {"inner", 0}, {"leaf_size", 30}}, .outputs = "meshes sky"});
  const auto sky = column_in<std::uint8_t>(plant, "organs.sky");
  double inside = 0, outside = 0, insiders = 0, outsiders = 0;
  for (std::size_t i = 0; i < sky.size(); ++i) {
    const float from = glm::distance(plant.organs[i].position, {0, 5, 0});
    if (from < 1) inside += sky[i], ++insiders;
    if (from > 2.8f) outside += sky[i], ++outsiders;
  }
  CHECK(inside / insiders < 0.6 * outside / outsiders);
}

TEST_CASE("two leaves stand at each origin and face the light") {
  const Plant plant = grow_tree({.parameters = {{"particles", 300}, {"sun", 90}, {"sun_height", 45}, {"sky", 0}}});
  CHECK(plant.organs.size() == 2 * count_of(plant, "particles"));
  const glm::vec3 light = towards_sun(90, 45);
  CHECK(light.x == doctest::Approx(std::sqrt(0.5f)));
  float facing = 0;
  for (const Organ& leaf : plant.organs) {
    const glm::vec4 q = leaf.rotation;
    CHECK(glm::length(q) == doctest::Approx(1).epsilon(1e-4));
    const glm::vec3 front(2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y));
    CHECK(glm::dot(front, light) > 0.8f);
    facing += glm::dot(front, light);
    CHECK(leaf.position == plant.segments[static_cast<std::size_t>(leaf.segment)].end);
  }
  CHECK(facing / static_cast<float>(plant.organs.size()) > 0.9f);
  CHECK(grow_tree({.parameters = {{"particles", 300}, {"leaves", 0}}}).organs.empty());
}

}  // namespace
}  // namespace panicle::particles
