// Obstacles in the way of trees and roots.
#include "models/particles/obstacles.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "models/particles/space_growing.hpp"
#include "models/tree/measures/measures.generated.hpp"

namespace panicle::particles {
namespace {

std::vector<Box> boxes_of(const std::vector<float>& rows) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i + 5 < rows.size(); i += 6)
    boxes.push_back({{rows[i], rows[i + 1], rows[i + 2]}, {rows[i + 3], rows[i + 4], rows[i + 5]}});
  return boxes;
}

// Checks that no trail passes an obstacle, and that all energy is at the target.
void check_round(const Plant& plant, const std::vector<float>& rows) {
  const Obstacles obstacles(boxes_of(rows), 0, -100, 100);
  const auto energies = column_in<float>(plant, "segments.energy");
  REQUIRE(energies.size() == plant.segments.size());
  float arrived = 0;
  for (std::size_t i = 0; i < plant.segments.size(); ++i) {
    const Segment& segment = plant.segments[i];
    CHECK_FALSE(obstacles.between(segment.start, segment.end));
    if (segment.parent < 0) arrived += energies[i];
  }
  CHECK(arrived == static_cast<float>(count_of(plant, "particles")));
}

float measure_of(const Plant& plant) { return plant.measures[static_cast<std::size_t>(tree::Measure::light)]; }

}  // namespace

TEST_CASE("a trunk goes round an obstacle on its axis") {
  for (const std::vector<float>& rows : {std::vector<float>{-0.5f, 1.5f, -0.5f, 0.5f, 2, 0.5f},
                                         {-0.4f, 3, -0.4f, 0.4f, 3.3f, 0.4f},
                                         {-0.5f, 0.6f, -0.5f, 0.5f, 1, 0.5f, -0.3f, 3, -0.3f, 0.6f, 3.5f, 0.3f}}) {
    CAPTURE(rows[1]);
    check_round(grow_tree({.parameters = {{"particles", 1500}}, .obstacles = rows}), rows);
  }
}

TEST_CASE("behind a wall it is dark, and a crown is thinner") {
  // The sun is low at the right; a thin wall is between it and the front half of the crown.
  const std::vector<std::pair<std::string_view, float>> parameters{
      {"particles", 1500}, {"pattern", 3}, {"sky", 0}, {"sun", 90}, {"sun_height", 10}, {"by_light", 1}};
  const auto grown = [&](const std::vector<float>& obstacles) {
    return grow_tree({.parameters = parameters, .outputs = "measures", .obstacles = obstacles});
  };
  const auto share_in_front = [](const Plant& plant) {
    const std::vector<std::size_t> tips = tips_of(plant);
    const auto front = std::count_if(tips.begin(), tips.end(), [&](auto tip) { return plant.segments[tip].end.z > 0; });
    return static_cast<double>(front) / static_cast<double>(tips.size());
  };
  const Plant open = grown({}), half_behind = grown({3.6f, 0, 0, 3.7f, 30, 10});
  CHECK(share_in_front(open) == doctest::Approx(0.5).epsilon(0.1));
  CHECK(share_in_front(half_behind) < 0.1);
  CHECK(measure_of(grown({3.6f, 0, -10, 3.7f, 30, 10})) < 0.5f * measure_of(open));
}

TEST_CASE("roots pass a stone right below the collar, even with few particles") {
  for (const std::vector<float>& stone :
       {std::vector<float>{-0.05f, -0.1f, -0.1f, 0.05f, -0.05f, 0.1f}, {-0.05f, -0.1f, -1, 1, -0.05f, 1}})
    for (const float particles : {10.0f, 300.0f}) {
      CAPTURE(stone[5]);
      CAPTURE(particles);
      const Plant plant = grow_root(
          {.parameters = {{"particles", particles}, {"width", 4}, {"depth", 4}, {"reach", 1.8f}}, .obstacles = stone});
      CHECK_FALSE(has_note(plant, "no way past"));
      check_round(plant, stone);
    }
}

TEST_CASE("a tap root goes round the stone below it, and is one again beyond") {
  const std::vector<float> stone{-0.1f, -0.6f, -0.1f, 0.1f, -0.4f, 0.1f};
  const Plant plant = grow_root({.parameters = {{"particles", 1500}}, .obstacles = stone});
  check_round(plant, stone);
  // Branches that cross a level below it near the axis.
  int strands = 0;
  for (const Segment& segment : plant.segments)
    strands += segment.start.y >= -0.75f && segment.end.y < -0.75f && std::hypot(segment.end.x, segment.end.z) < 0.01f;
  CHECK(strands <= 1);
}

}  // namespace panicle::particles
