// The influences on a tree's growth: light, bending, day length, hormone, age.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "models/particles/space_growing.hpp"
#include "models/tree/measures/measures.generated.hpp"
#include "near.hpp"

namespace panicle::particles {
namespace {

using tree::Measure;

float measure(const Plant& plant, Measure which) { return plant.measures[static_cast<std::size_t>(which)]; }

TEST_CASE("under a sky, the lower facing halves of twins hold at most 0.8 of the outer ones' particles") {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const auto halves = [seed](float light_exponent) {
      const Plant plant = grow_tree({.parameters = {{"crowns", 2},
                                                    {"distance", 6},
                                                    {"sky", 1},
                                                    {"absorption", 5},
                                                    {"by_light", light_exponent},
                                                    {"particles", 4000}},
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
  const auto share = [](float azimuth) {
    const Plant plant =
        grow_tree({.parameters = {{"sun", azimuth}, {"sun_height", 20}, {"sky", 0.2f}, {"particles", 2000}}});
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
    // From the place a metre down the twig.
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
  CHECK(measure(winter, Measure::crown_volume) < 0.9f * measure(autumn, Measure::crown_volume));
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
      const bool is_outside = p.x * p.x + p.z * p.z > 0.4f * 0.4f;
      if (is_outside) ++(p.y > 6 ? high : low);
      if (!is_outside && p.y > 6) ++leader;
    }
    return std::pair(static_cast<float>(high) / static_cast<float>(low), leader);
  };
  const auto [free, free_leader] = top(0);
  const auto [held, held_leader] = top(1);
  CHECK(held < 0.6f * free);
  CHECK(free_leader > 5);
  CHECK(2 * held_leader > free_leader);
}

TEST_CASE("with age, grown parts stay and thicken, particles run on evenly, and the tree is complete at the end") {
  const auto at = [](float age) {
    return grow_tree({.parameters = {{"age", age}, {"particles", 800}, {"leaves", 0}}});
  };
  const auto place = [](const glm::vec3& p) { return std::array{p.x, p.y, p.z}; };
  std::map<std::array<float, 3>, Segment> before;  // by the upper end, of which a place has but one
  std::map<std::array<float, 3>, bool> fronts;
  float length = 0;
  for (const float age : {0.0f, 10.0f, 10.5f, 35.0f, 60.0f, 90.0f, 100.0f}) {
    const Plant plant = at(age);
    CAPTURE(age);
    std::map<std::array<float, 3>, Segment> now;
    float sum = 0;
    for (const Segment& segment : plant.segments) {
      now[place(segment.end)] = segment;
      sum += glm::distance(segment.start, segment.end);
    }
    for (const auto& [end, segment] : before) {
      const auto found = now.find(end);
      REQUIRE(found != now.end());
      CHECK(found->second.radius >= segment.radius);
      // Only particles on their way there have come farther.
      if (!fronts.contains(place(segment.start))) CHECK(found->second.start == segment.start);
    }
    // Half a percent of age moves all particles, not only those that reach a place.
    if (age == 10.5f)
      for (const auto& [front, ball] : fronts)
        CHECK_FALSE(std::ranges::count_if(plant.organs, [&](const Organ& organ) {
                      return organ.tag == 1 && place(organ.position) == front && ball;
                    }) > 0);
    CHECK((age == 0 ? now.empty() : sum > length));
    std::uint32_t on_their_way = 0;
    fronts.clear();
    for (const Organ& organ : plant.organs) {
      if (organ.tag != 1) continue;
      ++on_their_way;
      fronts[place(organ.position)] = !now.contains(place(organ.position));
    }
    const auto arrived = column_in<float>(plant, "targets.energy");
    if (age == 0) CHECK(on_their_way == count_of(plant, "particles"));
    if (age == 100) CHECK(on_their_way == 0);
    if (age == 35) CHECK(on_their_way > 1);
    CHECK((arrived[0] == static_cast<float>(count_of(plant, "particles"))) == (age == 100));
    before = std::move(now);
    length = sum;
  }
}

TEST_CASE("every step of the run is visible, and the last one is the end") {
  const std::vector<SpaceOptions> trees{{.parameters = {{"particles", 20}}},
                                        {.parameters = {{"particles", 150}, {"leaves", 0}, {"slant", 2}}},
                                        {.parameters = {{"particles", 90}, {"crowns", 2}, {"distance", 6}}},
                                        {.parameters = {{"particles", 60}, {"stems", 3}, {"pull", 0}}, .seed = 5}};
  for (const SpaceOptions& tree : trees) {
    const auto at = [&](float age) {
      SpaceOptions options = tree;
      options.parameters.push_back({"age", age});
      return grow_tree(options);
    };
    const Plant whole = at(100);
    const std::uint32_t steps = count_of(whole, "steps");
    CAPTURE(steps);
    CHECK(steps > 5);
    std::vector<glm::vec3> before;
    for (std::uint32_t step = 0; step <= steps; ++step) {
      const float age = step == steps ? 100 : 100 * (static_cast<float>(step) + 0.25f) / static_cast<float>(steps);
      std::vector<glm::vec3> now;
      const Plant plant = at(age);
      for (const Segment& segment : plant.segments) now.push_back(segment.start);
      for (const Organ& organ : plant.organs) now.push_back(organ.scale * glm::vec3(1));
      CAPTURE(step);
      CHECK(now != before);
      before = std::move(now);
    }
  }
}

TEST_CASE("leaves unfold once all particles have arrived, from below, each from nothing to its size") {
  const auto at = [](float age) {
    return grow_tree({.parameters = {{"age", age}, {"particles", 400}, {"leaves", 1}}});
  };
  const auto size_at = [](const Plant& plant) {
    std::map<std::array<float, 3>, float> sizes;
    for (const Organ& organ : plant.organs)
      if (organ.tag == 0) sizes[{organ.position.x, organ.position.y, organ.position.z}] = organ.scale;
    return sizes;
  };
  const auto whole = size_at(at(100));
  CHECK(whole.size() == count_of(at(100), "leaves"));
  std::map<std::array<float, 3>, float> before;
  for (const float age : {0.0f, 40.0f, 80.0f, 87.0f, 92.0f, 97.0f, 100.0f}) {
    CAPTURE(age);
    const Plant plant = at(age);
    const auto now = size_at(plant);
    const bool on_their_way = std::ranges::any_of(plant.organs, [](const Organ& organ) { return organ.tag == 1; });
    CHECK(on_their_way == (age <= 80));
    CHECK(now.empty() == on_their_way);
    float lowest_share = 0, highest_share = 0;
    const auto height = [](const auto& one, const auto& other) { return one.first[1] < other.first[1]; };
    if (!now.empty()) {
      const auto [low, high] = std::ranges::minmax_element(whole, height);
      lowest_share = now.contains(low->first) ? now.at(low->first) / low->second : 0;
      highest_share = now.contains(high->first) ? now.at(high->first) / high->second : 0;
    }
    if (age == 92) CHECK(lowest_share > highest_share + 0.2f);
    for (const auto& [where, size] : before) CHECK(now.at(where) >= size);
    for (const auto& [where, size] : now) CHECK(size <= whole.at(where));
    before = now;
  }
  CHECK(before == whole);
}

TEST_CASE("where the boundary grows, a young tree is a small tree with the same starts of twigs") {
  const auto at = [](float age) {
    return grow_tree({.parameters = {{"life", 1}, {"age", age}, {"particles", 3000}, {"pattern", 2}, {"inner", 0}},
                      .outputs = "measures"});
  };
  const Plant young = at(40), grown = at(100);
  CHECK(measure(young, Measure::height) == near(0.4f * measure(grown, Measure::height), 0.05));
  CHECK(measure(young, Measure::crown_volume) == near(0.064f * measure(grown, Measure::crown_volume), 0.02));
  const float share =
      static_cast<float>(count_of(young, "particles")) / static_cast<float>(count_of(grown, "particles"));
  CHECK(share == near(0.064f, 0.25));
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

TEST_CASE("a ragged crown is inside its boundary, with hollows, and has as many particles") {
  const auto tips = [](float ragged) {
    const Plant plant =
        grow_tree({.parameters = {{"particles", 3000}, {"ragged", ragged}, {"inner", 0}, {"pattern", 2}}});
    std::vector<glm::vec3> found;
    for (const std::size_t tip : tips_of(plant)) found.push_back(plant.segments[tip].end);
    return found;
  };
  // The greatest distance from the middle, by direction.
  const auto reach = [](const std::vector<glm::vec3>& places) {
    std::vector<float> farthest(12 * 6, 0);
    for (const glm::vec3& place : places) {
      const glm::vec3 from = place - glm::vec3(0, 5, 0);
      const float far = glm::length(from);
      CHECK(far <= 3.001f);
      const auto around = static_cast<std::size_t>((std::atan2(from.z, from.x) / 6.2832f + 0.5f) * 11.999f);
      const auto up = static_cast<std::size_t>((from.y / far + 1) / 2 * 5.999f);
      farthest[12 * up + around] = std::max(farthest[12 * up + around], far);
    }
    float sum = 0, squares = 0;
    for (const float far : farthest) sum += far, squares += far * far;
    const float mean = sum / 72;
    return std::sqrt(squares / 72 - mean * mean);
  };
  const auto clipped = tips(0), ragged = tips(0.4f);
  CHECK(ragged.size() > 0.8 * static_cast<double>(clipped.size()));
  CHECK(reach(ragged) > 2 * reach(clipped));
}

}  // namespace
}  // namespace panicle::particles
