#include "models/bunch/natural/situation.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "foundation/random.hpp"
#include "models/bunch/natural/stages.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

// 200 mm long, 60 mm to every side.
const Envelope drum(Profile{400, {{{120, 40}, {120, 40}, {120, 40}, {120, 40}}}}, 0.5f, 60);

Situation at(const glm::vec3& foot, const glm::vec3& heading, const glm::vec3& sun, float lean = 0) {
  const std::vector<Internode> internodes{stem(-1, Kind::axis, {0, 0, 0}, foot),
                                          stem(0, Kind::pedicel, foot, foot + heading)};
  const std::vector<Flower> flowers{flower_on(1, heading)};
  const std::vector<BunchEnvelope> bounds{{drum, lean}};
  return situate(flowers, internodes, bounds, 10, sun)[0];
}

}  // namespace

TEST_CASE("the sun is in front at 0, at the right at 90, and at the given height") {
  CHECK(glm::length(towards_sun(0, 0) - glm::vec3(0, 0, 1)) < 1e-6f);
  CHECK(glm::length(towards_sun(90, 0) - glm::vec3(1, 0, 0)) < 1e-6f);
  CHECK(towards_sun(40, 45).y == doctest::Approx(0.7071));
}

TEST_CASE("the side that faces the sun is lit, the other is not") {
  const glm::vec3 right = towards_sun(90, 0);
  CHECK(at({50, -100, 0}, {1, 0, 0}, right).lit > 0.9f);
  CHECK(at({-50, -100, 0}, {-1, 0, 0}, right).lit < 0.1f);
  CHECK(at({0, -100, 50}, {0, 0, 1}, right).lit == doctest::Approx(0.5).epsilon(0.05));
}

TEST_CASE("`along` goes from base to tip; `misplaced` is the distance outside in berry widths, to every side") {
  const glm::vec3 sun = towards_sun(0, 0);
  CHECK(at({0, -20, 0}, {0, -1, 0}, sun).along == doctest::Approx(0.13).epsilon(0.05));
  CHECK(at({0, -150, 0}, {0, -1, 0}, sun).along == doctest::Approx(0.78).epsilon(0.05));
  CHECK(at({40, -100, 0}, {1, 0, 0}, sun).misplaced == 0);
  // A flower's berry would hang half a width beyond its pedicel's end, and that would droop.
  CHECK(at({73, -100, 0}, {1, 0, 0}, sun).misplaced == doctest::Approx(1.78).epsilon(0.02));
  CHECK(at({0, -213, 0}, {0, -1, 0}, sun).misplaced == doctest::Approx(1.9).epsilon(0.02));
}

TEST_CASE("places of a leaning bunch are in its own frame") {
  const glm::vec3 sun = towards_sun(0, 0);
  const Situation leaning = at({-100, 0, 0}, {-1, 0, 0}, sun, 90);
  CHECK(leaning.misplaced == 0);
  CHECK(leaning.along == doctest::Approx(0.53).epsilon(0.05));
}

TEST_CASE("places are in the bunch's frame and light in the world's, for every stance") {
  const std::vector<Flower> flowers{flower_on(0, {0, 0, 1})};
  const auto hung = [&](const Stance& stance, const glm::vec3& sun) {
    const UprightTransform upright(stance);
    const glm::vec3 start = stance.foot + upright.way_back({10, -100, 40}), on = upright.way_back({0, 0, 10});
    const std::vector<Internode> internodes{stem(-1, Kind::axis, start, start + on)};
    std::vector<Flower> turned = flowers;
    turned[0].heading = upright.way_back({0, 0, 1});
    const std::vector<BunchEnvelope> bounds{{drum, stance}};
    return situate(turned, internodes, bounds, 10, sun)[0];
  };
  const Situation upright = hung({}, towards_sun(0, 0));
  for (const Stance& stance : {Stance{80, 1, {-200, 5, 3}}, Stance{30, 3, {0, 0, -90}}}) {
    const Situation one = hung(stance, towards_sun(0, 0));
    CHECK(glm::length(one.place - upright.place) < 1e-3f);
    CHECK(one.misplaced == doctest::Approx(upright.misplaced));
  }
  // Its foot is far to the left, and it leans: its front is as bright as any bunch's.
  CHECK(hung({80, 1, {-200, 5, 3}}, towards_sun(0, 0)).lit == doctest::Approx(upright.lit).epsilon(0.02));
  // Leaning to the front by a right angle it shows its front to the sky.
  CHECK(hung({90, 2, {0, 0, 90}}, {0, 1, 0}).lit > 0.8f);
}

TEST_CASE("turns to set are spread evenly over an axis, and the second bunch has its own") {
  std::vector<float> turns;
  for (int depth = 0; depth < 34; ++depth) {
    Flower flower = flower_on(0, {0, -1, 0}, 5);
    flower.depth = depth;
    turns.push_back(turn_of(flower, 1));
  }
  std::sort(turns.begin(), turns.end());
  for (std::size_t i = 1; i < turns.size(); ++i) CHECK(turns[i] - turns[i - 1] < 0.06f);
  CHECK(turns.front() >= 0);
  CHECK(turns.back() < 1);
  Flower first = flower_on(0, {0, -1, 0}, 5), second = first;
  second.bunch = 1;
  CHECK(turn_of(first, 1) != turn_of(second, 1));
  CHECK(turn_of(first, 1) != turn_of(first, 2));
}

TEST_CASE("a raceme's flowers are never misplaced by long pedicels") {
  const glm::vec3 foot(0, -100, 0), far(95, -100, 0);
  const std::vector<BunchEnvelope> bounds{{drum, 0}};
  const std::vector<Flower> flowers{flower_on(1, {1, 0, 0})};
  const auto misplaced = [&](Kind parent_kind) {
    const std::vector<Internode> internodes{stem(-1, parent_kind, {0, 0, 0}, foot), stem(0, Kind::pedicel, foot, far)};
    return situate(flowers, internodes, bounds, 10, towards_sun(0, 0))[0].misplaced;
  };
  CHECK(misplaced(Kind::rachis) == 0);
  CHECK(misplaced(Kind::axis) > 1);
}
