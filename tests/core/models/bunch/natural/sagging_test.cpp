#include "models/bunch/natural/settling/sagging.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

using namespace panicle;
using namespace panicle::bunch;

namespace {

Swelling berry_on(std::uint32_t branch, float half = 8) {
  Swelling berry;
  berry.branch = branch;
  berry.heading = {0, -1, 0};
  berry.stalk = 8;
  berry.half_width = berry.half_length = half;
  return berry;
}

// The rachis, and a level axis in two parts from its middle.
std::vector<Branch> level_axis(float radius, float length = 20) {
  return {{{0, 0, 0}, {0, -50, 0}, -1, 3, 0.05f, false},
          {{0, -50, 0}, {length, -50, 0}, 0, radius, 0.4f, true},
          {{length, -50, 0}, {2 * length, -50, 0}, 1, radius, 0.4f, true}};
}

// The angle of a branch to its parent after bending, radians.
float bend_of(const std::vector<Branch>& branches, const std::vector<Swelling>& berries, std::size_t k,
              float size = 1) {
  Sagging sagging(branches, berries);
  const auto turned = sagging.turned(size);
  const glm::vec3 own = turned[k] * glm::vec3(1, 0, 0), parent = turned[k - 1] * glm::vec3(1, 0, 0);
  return std::acos(std::min(1.0f, glm::dot(own, parent)));
}

}  // namespace

TEST_CASE(
    "pedicels droop until their berries are half as wide as ripe: level ones to 37 degrees, upright ones over, hanging "
    "ones not at all") {
  const glm::vec3 level(1, 0, 0), up(0, 1, 0), down(0, -1, 0);
  CHECK(drooping(level, 0) == level);
  CHECK(drooping(down, 1) == down);
  CHECK(std::asin(-drooping(level, 1).y) == doctest::Approx(std::atan(0.75)));
  CHECK(drooping(up, 1).y <= 0);
  CHECK(glm::length(drooping(up, 1)) == doctest::Approx(1));
  float before = 1;
  const glm::vec3 leaning = glm::normalize(glm::vec3(1, 0.5f, 0));
  for (float size = 0; size <= 0.5f; size += 0.1f) {
    const glm::vec3 way = drooping(leaning, size);
    CHECK(glm::length(way) == doctest::Approx(1));
    CHECK(way.y < before);
    before = way.y;
  }
  CHECK(drooping(leaning, 0.5f) == drooping(leaning, 1));
}

TEST_CASE("a beam's law: twice the load bends twice as much, twice the radius a sixteenth") {
  const std::vector<Swelling> one{berry_on(2, 4)}, two{berry_on(2, 4), berry_on(2, 4)};
  const float stout = bend_of(level_axis(1.2f), one, 2);
  REQUIRE(stout > 0.001f);
  CHECK(bend_of(level_axis(1.2f), two, 2) == doctest::Approx(2 * stout).epsilon(0.03));
  CHECK(bend_of(level_axis(0.6f), one, 2) > 10 * stout);
  CHECK(bend_of(level_axis(0.6f), one, 2) < 16 * stout);  // no branch bends without end
  CHECK(bend_of(level_axis(0.05f), two, 2) < 0.51f);
}

TEST_CASE("branches without berries, and those that do not sag, stay as they are") {
  const std::vector<Branch> branches = level_axis(1);
  Sagging bare(branches, {});
  for (const glm::quat& turn : bare.turned(1)) CHECK(turn == glm::quat(1, 0, 0, 0));
  Sagging laden(branches, std::vector<Swelling>{berry_on(2)});
  CHECK(laden.turned(1)[0] == glm::quat(1, 0, 0, 0));
  std::vector<Swelling> late{berry_on(2)};
  late[0].late = true;
  Sagging waiting(branches, late);
  CHECK(waiting.turned(1)[2] == glm::quat(1, 0, 0, 0));
}

TEST_CASE("axes grow up against their load: ripe, their berries hang where the text has them") {
  const std::vector<Branch> branches = level_axis(0.9f);
  const std::vector<Swelling> berries{berry_on(1), berry_on(2)};
  Sagging sagging(branches, berries);
  // The mean of the ends of the axis's two parts.
  const auto mean = [&](float size) {
    const auto turned = sagging.turned(size);
    const glm::vec3 first = turned[1] * (branches[1].end - branches[1].start);
    return first + 0.5f * (turned[2] * (branches[2].end - branches[2].start));
  };
  const glm::vec3 ripe = glm::normalize(mean(1)), young = glm::normalize(mean(0));
  CHECK(std::abs(ripe.y) < 0.001f);
  CHECK(young.y > 0.05f);
  CHECK(mean(0.25f).y > 0);
  CHECK(mean(0.25f).y < mean(0).y);
  CHECK(mean(0.5f) == mean(1));
}

TEST_CASE("an axis sags towards the side it leans to, whichever that is") {
  for (const glm::vec3 way : {glm::vec3(1, 0, 0), glm::vec3(0, 0, -1), glm::normalize(glm::vec3(-1, 0.5f, 1))}) {
    const std::vector<Branch> branches{
        {{0, 0, 0}, {0, -50, 0}, -1, 3, 0.05f, false},
        {{0, -50, 0}, glm::vec3(0, -50, 0) + way * 20.0f, 0, 1, 0.4f, true},
        {glm::vec3(0, -50, 0) + way * 20.0f, glm::vec3(0, -50, 0) + way * 40.0f, 1, 1, 0.4f, true}};
    Sagging sagging(branches, std::vector<Swelling>{berry_on(2)});
    const auto turned = sagging.turned(1);
    CHECK((turned[2] * way).y < (turned[1] * way).y - 0.01f);
  }
}

TEST_CASE("the turns of a size do not depend on sizes queried before") {
  const std::vector<Branch> branches = level_axis(1.2f);
  const std::vector<Swelling> berries{berry_on(2)};
  Sagging sagging(branches, berries);
  for (const float size : {0.1f, 0.3f, 0.6f, 1.0f, 0.3f}) {
    Sagging fresh(branches, berries);
    const auto turned = sagging.turned(size), own = fresh.turned(size);
    for (std::size_t k = 0; k < branches.size(); ++k) CHECK(turned[k] == own[k]);
  }
}
