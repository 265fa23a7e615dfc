// How a bunch fills its outline, and how much lies outside.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "foundation/mathematics.hpp"
#include "models/bunch/measures/balls.hpp"

using namespace panicle;
using namespace panicle::bunch;
using enum Measure;

TEST_CASE("coverage and spill of a ball on the outline's edge") {
  const Envelope envelope = block(30, 200);
  const double disc = 100 * pi;
  const Measured edge(balls({{30, -100, 0}}, 10), hung(envelope));
  CHECK(edge[coverage_front] == about(disc / 2 / envelope.area(0), 0.02));
  CHECK(edge[coverage_side] == about(disc / envelope.area(2), 0.02));
  CHECK(edge[coverage] == about(1.5 * disc / (envelope.area(0) + envelope.area(2)), 0.02));
  CHECK(edge[spill] == 0);
  // The outline grown by the radius ends at the centre of a ball that touches it from outside.
  const Measured outside(balls({{40, -100, 0}}, 10), hung(envelope));
  CHECK(outside[spill_front] == about(0.5, 0.05));
  CHECK(outside[spill_side] == 0);
  CHECK(outside[spill] == about(0.25, 0.05));
  const Measured far(balls({{0, -100, 0}, {90, -100, 0}}, 10), hung(envelope));
  CHECK(far[spill_front] == about(0.5));
}

TEST_CASE("a full outline is covered, gaps smaller than a berry count as full, larger ones do not") {
  const Envelope envelope = block(40, 200);
  const Measured full(balls(lattice(10, within(envelope)), 8), hung(envelope));
  CHECK(full[coverage] > 0.99f);
  CHECK(full[spill] < 0.003f);
  const Envelope wide = block(60, 200);
  const auto flat = [](const glm::vec3& p) { return std::abs(p.x) < 60 && std::abs(p.z) < 1 && p.y > -200; };
  const Measured loose(balls(lattice(20, flat), 8), hung(wide));
  const Measured sparse(balls(lattice(40, flat), 8), hung(wide));
  CHECK(loose[coverage_front] > 1.15 * pi * 64 / 400);
  CHECK(sparse[coverage_front] < 1.1 * pi * 64 / 1600);
}

TEST_CASE("a second outline leans to the left, and both count as one") {
  const Envelope envelope = spindle(40, 160);
  const SinCos turn = sincos_degrees(50);
  std::vector<glm::vec3> leaning = lattice(10, within(envelope));
  for (glm::vec3& p : leaning) p = {p.x * turn.cosine + p.y * turn.sine, p.y * turn.cosine - p.x * turn.sine, p.z};
  CHECK(leaning.back().x < 0);
  const GrownBunch grown = balls(leaning, 8);
  const Measured right(grown, hung(envelope, 50)), wrong(grown, hung(envelope, -50));
  CHECK(right[coverage_front] > 0.98f);
  CHECK(right[coverage_side] > 0.98f);
  CHECK(right[spill] < 0.01f);
  CHECK(wrong[coverage_front] < 0.6f);
  CHECK(wrong[spill_front] > 0.3f);
  std::vector<HungEnvelope> both = hung(envelope);
  both.push_back({envelope, 50});
  const Measured half(grown, both);
  CHECK(half[coverage_front] > 0.5f);
  CHECK(half[coverage_front] < 0.8f);
  CHECK(half[spill] < 0.01f);
}

TEST_CASE("an outline that barely leans is drawn as an upright one") {
  const Envelope envelope = spindle(40, 160);
  const GrownBunch grown = balls(lattice(14, within(envelope)), 7);
  const Measured upright(grown, hung(envelope, 0)), leaning(grown, hung(envelope, 0.2f));
  for (const Measure key : {coverage_front, coverage_side}) CHECK(leaning[key] == about(upright[key], 0.02));
}

TEST_CASE("spill of one view is divided by the silhouettes of both") {
  const Envelope envelope = block(30, 200);
  const std::vector<HungEnvelope> upright = hung(envelope);
  const Measured front(balls({{40, -100, 0}}, 10), upright), side(balls({{0, -100, 40}}, 10), upright);
  CHECK(side[spill_front] == 0);
  CHECK(side[spill_side] == about(front[spill_front], 0.05));
  CHECK(side[spill] == about(front[spill], 0.05));
  CHECK(side[spill] > 0.2f);
}

TEST_CASE("a small move is a small change of the fit") {
  const Envelope envelope = spindle(45, 180);
  std::vector<glm::vec3> places = lattice(17, within(envelope));
  Measured before(balls(places, 8), hung(envelope));
  float worst = 0;
  for (int step = 0; step < 40; ++step) {
    for (glm::vec3& place : places) place += glm::vec3(0.11f, -0.07f, 0.05f);
    const Measured after(balls(places, 8), hung(envelope));
    worst = std::max(worst, std::abs(after[coverage] - before[coverage]));
    before = after;
  }
  CHECK(worst < 0.006f);
}
