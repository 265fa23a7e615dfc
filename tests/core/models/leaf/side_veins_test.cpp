#include "models/leaf/shape/side_veins.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string>

#include "models/leaf/outlines.hpp"

using namespace panicle;
using namespace panicle::particles;
using namespace panicle::particles::leaf;

namespace {

struct Built {
  Margin margin;
  Outline outline;
  std::vector<Ribs> ribs;
};

Built built(const RibPlan& plan, std::span<const float> rows, const Teeth& teeth = {}) {
  std::vector<std::string> notes;
  const auto points = read_outline(rows, notes);
  REQUIRE(points);
  const auto drawn = spline(points.value());
  REQUIRE(drawn);
  Margin margin = toothed(drawn.value(), teeth, notes);
  Outline outline(margin.points);
  std::vector<Ribs> ribs = build_ribs(plan, margin, outline, {0, 0, 0}, notes);
  CHECK(notes.empty());
  return {std::move(margin), std::move(outline), std::move(ribs)};
}

// The ribs' lines, each from its root to its end: where several go on from a place, the first is the same line's.
std::vector<std::vector<glm::vec3>> lines_of(const Ribs& ribs) {
  std::vector<std::vector<glm::vec3>> lines{{ribs.places[0]}};
  std::vector<std::size_t> line(ribs.places.size(), 0);
  std::vector<bool> continued(ribs.places.size(), false);
  for (std::size_t i = 1; i < ribs.places.size(); ++i) {
    const auto next = static_cast<std::size_t>(ribs.next[i]);
    line[i] = line[next];
    if (continued[next]) {
      line[i] = lines.size();
      lines.push_back({ribs.places[next]});
    }
    continued[next] = true;
    lines[line[i]].push_back(ribs.places[i]);
  }
  return lines;
}

std::vector<float> rows_of(std::string_view name) {
  const auto outlines = leaf_outlines();
  return std::find_if(outlines.begin(), outlines.end(), [&](const auto& one) { return one.name == name; })->rows;
}

float from_tooth(const Margin& margin, const glm::vec3& p, std::size_t& tooth) {
  float least = 9;
  for (const std::size_t i : margin.teeth)
    if (const float away = glm::distance(glm::vec3(margin.points[i], 0), p); away < least) {
      least = away;
      tooth = i;
    }
  return least;
}

}  // namespace

TEST_CASE("craspedodromous side veins end in tips of teeth, each in one of its own, near where they would have ended") {
  for (const ToothShape shape : {ToothShape::dentate, ToothShape::serrate, ToothShape::crenate}) {
    const RibPlan plan{.secondaries = 7, .angle = 50, .course = Course::teeth};
    const Teeth teeth{12, 0.3f, shape};
    const Built leaf = built(plan, {}, teeth);
    RibPlan open = plan;
    open.course = Course::margin;
    const auto lines = lines_of(leaf.ribs[0]), free = lines_of(built(open, {}, teeth).ribs[0]);
    REQUIRE(lines.size() == 15);
    REQUIRE(free.size() == 15);
    std::set<std::size_t> taken;
    float moved = 0;
    for (std::size_t k = 1; k < lines.size(); ++k) {
      CAPTURE(k);
      std::size_t tooth = 0;
      CHECK(from_tooth(leaf.margin, lines[k].back(), tooth) < 0.005f);
      CHECK(taken.insert(tooth).second);
      CHECK(lines[k].front() == free[k].front());
      moved += glm::distance(lines[k].back(), free[k].back());
      for (const glm::vec3& p : lines[k]) CHECK(leaf.outline.contains(p));
    }
    CHECK(moved / 14 < 0.06f);  // a tooth is 0.09 wide
  }
}

TEST_CASE("where there are fewer teeth than side veins, the others end before the margin") {
  const Built leaf = built({.secondaries = 9, .course = Course::teeth}, {}, {4, 0.3f, ToothShape::dentate});
  const auto lines = lines_of(leaf.ribs[0]);
  REQUIRE(lines.size() == 19);
  std::size_t served = 0, tooth = 0;
  for (std::size_t k = 1; k < lines.size(); ++k)
    if (from_tooth(leaf.margin, lines[k].back(), tooth) < 0.005f)
      ++served;
    else
      CHECK(leaf.outline.distance(lines[k].back()) < 0.05f);
  CHECK(served >= 4);
  CHECK(served <= 8);
}

TEST_CASE("corners that stand out are teeth too, to which side veins of palmate leaves run") {
  const std::vector<float> rows = mirrored({{0, 0, 1},
                                            {0.2f, -0.05f, 0},
                                            {0.45f, -0.1f, 1},
                                            {0.4f, 0.1f, 0},
                                            {0.62f, 0.36f, 3},
                                            {0.4f, 0.42f, 0},
                                            {0.42f, 0.68f, 1},
                                            {0.26f, 0.56f, 0},
                                            {0.22f, 0.7f, 1},
                                            {0.1f, 0.8f, 0},
                                            {0, 1, 3}});
  const Built leaf = built({.kind = RibKind::palmate, .secondaries = 6, .course = Course::teeth}, rows);
  CHECK(leaf.margin.teeth.size() == 6);
  std::set<std::size_t> served;
  for (const Ribs& ribs : leaf.ribs)
    for (const auto& line : lines_of(ribs)) {
      std::size_t tooth = 0;
      if (from_tooth(leaf.margin, line.back(), tooth) < 0.005f) served.insert(tooth);
    }
  CHECK(served.size() >= 4);
}

TEST_CASE("brochidodromous side veins keep off the margin and bend up along it to just below the next") {
  const Built leaf = built({.secondaries = 8, .angle = 55, .arch = 0.2f, .course = Course::arch}, {});
  const Built open = built({.secondaries = 8, .angle = 55, .arch = 0.2f}, {});
  const float clear = 0.32f * 0.985f / 8;  // of the spacing of side veins
  const auto lines = lines_of(leaf.ribs[0]), free = lines_of(open.ribs[0]);
  REQUIRE(lines.size() == free.size());
  std::size_t looped = 0;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    CAPTURE(k);
    const std::vector<glm::vec3>& line = lines[k];
    for (const glm::vec3& p : line)
      if (glm::distance(p, line.front()) > 0.12f) CHECK(leaf.outline.distance(p) > 0.45f * clear);
    if (line.size() < 4) continue;
    // At its end it points to the tip, below the vein above it or the midrib.
    const glm::vec3 way = glm::normalize(line.back() - line[line.size() - 3]);
    float next = 9;
    for (std::size_t other = 0; other < lines.size(); ++other)
      if (other != k)
        for (const glm::vec3& p : lines[other]) next = std::min(next, glm::distance(p, line.back()));
    looped += way.y > 0.9f && next < clear + 0.02f;
    CHECK(way.y > 0.6f);
    // Not past it.
    if (k + 1 < lines.size() && lines[k + 1].back().x * line.back().x > 0) CHECK(line.back().y < lines[k + 1].back().y);
  }
  CHECK(looped >= 12);
  // Otherwise they run on to the margin.
  for (std::size_t k = 1; k < free.size(); ++k) CHECK(open.outline.distance(free[k].back()) < 0.04f);
}

TEST_CASE("the vein to a lobe keeps clear of the bays beside it, and alike on both sides") {
  const Built leaf = built({.angle = 48}, rows_of("oak"));
  const auto lines = lines_of(leaf.ribs[0]);
  REQUIRE(lines.size() == 9);
  for (std::size_t k = 1; k < lines.size(); ++k) {
    CAPTURE(k);
    const glm::vec3 root = lines[k].front(), end = lines[k].back();
    for (const glm::vec3& p : lines[k])
      if (glm::distance(p, root) > 0.06f && glm::distance(p, end) > 0.05f) CHECK(leaf.outline.distance(p) > 0.01f);
    const bool mirrored = std::any_of(lines.begin() + 1, lines.end(), [&](const auto& other) {
      return glm::distance(other.back(), glm::vec3(-end.x, end.y, 0)) < 1e-3f && other.size() == lines[k].size();
    });
    CHECK(mirrored);
  }
}
