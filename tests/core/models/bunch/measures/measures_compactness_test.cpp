// The density of a bunch.
#include "models/bunch/measures/images/measures_compactness.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "models/bunch/measures/balls.hpp"

using namespace panicle;
using namespace panicle::bunch;
using enum Measure;

namespace {

bool in_box(const glm::vec3& p) { return std::abs(p.x) < 40 && std::abs(p.z) < 40 && p.y > -150; }

// The density note of balls from all pairs: docs/measuring.md in double.
double note_of(const std::vector<glm::vec3>& centres, double radius, double seen) {
  const double d = 2 * radius;
  double gap = 0, contacts = 0, pressed = 0;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    std::vector<double> gaps(3, d);
    for (std::size_t j = 0; j < centres.size(); ++j) {
      if (j == i) continue;
      const double one = glm::length(glm::dvec3(centres[j]) - glm::dvec3(centres[i])) - d;
      contacts += one < 0.03 * d;
      pressed += std::max(0.0, -one) / (6 * d);
      gaps.push_back(std::max(0.0, one));
    }
    std::sort(gaps.begin(), gaps.end());
    gap += (gaps[0] + gaps[1] + gaps[2]) / 3;
  }
  const auto share = [&](double sum, double whole) {
    return std::min(1.0, sum / static_cast<double>(centres.size()) / whole);
  };
  return 1 + 2 * (1 - share(gap, 0.5 * d)) + 2 * (1 - std::min(1.0, seen / 0.7)) + 2 * share(contacts, 6) +
         2 * share(pressed, 0.16);
}

}  // namespace

TEST_CASE("the note of density is the same as from all pairs") {
  double least = 9, most = 1;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    std::vector<glm::vec3> centres;
    const std::uint64_t count = 1 + seed;
    const auto draw = [&](std::uint64_t k) { return uniform(5000 * (seed + 1) + k) - 0.5f; };
    const float extent = 15 * std::cbrt(static_cast<float>(count)) * (0.8f + uniform(seed));
    for (std::uint64_t i = 0; i < count; ++i)
      centres.push_back(extent * glm::vec3(draw(3 * i), draw(3 * i + 1), draw(3 * i + 2)));
    const float radius = 3 + 5 * uniform(seed + 77), seen = uniform(seed + 99);
    Subject subject(balls(centres, radius));
    const float note = density_note(subject, measure_compactness(subject), seen);
    CHECK(note == about(note_of(centres, radius, seen), 1e-3));
    least = std::min<double>(least, note);
    most = std::max<double>(most, note);
  }
  CHECK(least < 2.5);
  CHECK(most > 5);
}

TEST_CASE("closer berries have a higher density note, from the loosest to the densest") {
  const Envelope envelope = block(40, 200);
  float before = 0;
  for (const float radius : {4.0f, 6.0f, 7.0f, 7.49f, 8.0f, 8.5f, 9.0f}) {
    CAPTURE(radius);
    Subject subject(balls(lattice(15, within(envelope)), radius));
    const float seen = std::max(0.0f, 0.8f - radius / 10);
    const float note = density_note(subject, measure_compactness(subject), seen);
    CHECK((note > before || radius > 8));
    CHECK(note == about(note_of(lattice(15, within(envelope)), radius, seen), 1e-3));
    before = note;
  }
  CHECK(before > 8);
  Subject touching(balls(lattice(15, in_box), 7.5f));
  const Compactness close = measure_compactness(touching);
  CHECK(close.gap < 1e-3f);
  CHECK(close.contacts > 4.5f);
  CHECK(close.contacts < 6);
  CHECK(close.pressed < 1e-3f);
  Subject apart(balls({{0, 0, 0}, {25, 0, 0}}, 10));
  CHECK(measure_compactness(apart).gap == about((5 + 20 + 20) / 3.0, 1e-4));
}

TEST_CASE("fingers touch along their sides, and have their gap from skin to skin") {
  const auto gap_of = [](float apart, const glm::vec3& along, const glm::vec3& away) {
    GrownBunch grown = balls({{0, -50, 0}, glm::vec3(0, -50, 0) + away * apart}, 10);
    for (std::size_t i = 0; i < 2; ++i) {
      grown.berries[i].direction = along;
      grown.traits[i].length = 0.06f;
    }
    return Measured(grown, {})[gap];
  };
  const glm::vec3 down(0, -1, 0), right(1, 0, 0);
  const float width = 20, length = 60, mean = width * std::cbrt(length / width);
  const auto expected = [&](float apart) {
    return (apart + 2 * mean) / 3;
  };  // of the nearest three, two of which are missing
  CHECK(gap_of(width + 4, down, right) == about(expected(4), 0.01));
  CHECK(gap_of(length + 4, down, down) == about(expected(4), 0.01));
}
