// Published grammars draw the published shapes: their turtles' lines have the properties that the figures and captions
// show. A wrong production leaves the grid, visits a point twice or does not close.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <set>

#include "lsystem/published.hpp"

using namespace panicle;
using namespace panicle::tests;
using glm::vec3;

namespace {

Recorder drawing(const char* name, std::uint32_t steps, const Inputs& inputs = {}) {
  const BoundPointer bound = compiled_published(published(name), inputs);
  Recorder recorder;
  sound(lsystem::interpret(*bound, *derived(*bound, steps).string, upright, recorder, 1, Limits{}));
  return recorder;
}

using Point = std::array<int, 3>;

// Rounded to a hundredth of the unit, so that points of any lattice are distinct.
Point rounded(const vec3& at) {
  const auto whole = [](float x) { return static_cast<int>(std::lround(100 * x)); };
  return {whole(at.x), whole(at.y), whole(at.z)};
}

std::vector<Point> way(const Recorder& of) {
  std::vector<Point> points = {rounded(of.lines.front().before.position)};
  for (const Recorder::Line& line : of.lines) points.push_back(rounded(line.after.position));
  return points;
}

// The lattice's extent in points along each axis, of unit distance.
Point extent(const std::vector<Point>& points) {
  Point found{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto by = [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), by);
    found[axis] = ((*high)[axis] - (*low)[axis]) / 100 + 1;
  }
  return found;
}

std::size_t different(const std::vector<Point>& points) { return std::set<Point>(points.begin(), points.end()).size(); }

// Lines without direction, each once.
std::size_t different_lines(const Recorder& of) {
  std::set<std::pair<Point, Point>> lines;
  for (const Recorder::Line& line : of.lines) {
    const Point a = rounded(line.before.position), b = rounded(line.after.position);
    lines.insert({std::min(a, b), std::max(a, b)});
  }
  return lines.size();
}

float length_of(const Recorder::Line& line) { return glm::length(line.after.position - line.before.position); }

double length_of(const Recorder& of) {
  double sum = 0;
  for (const Recorder::Line& line : of.lines) sum += length_of(line);
  return sum;
}

}  // namespace

TEST_CASE("figures 1.6 to 1.9: islands close") {
  for (const char* name : {"koch-island", "koch-island-18", "islands-and-lakes", "koch-curve-a", "koch-curve-b",
                           "koch-curve-c", "koch-curve-d", "koch-curve-e", "koch-curve-f"}) {
    INFO(name);
    const std::vector<Point> points = way(drawing(name, 2));
    CHECK(points.front() == points.back());
    CHECK(extent(points)[2] == 1);
  }
  // Its generator goes three times as far as an edge.
  CHECK(extent(way(drawing("quadratic-snowflake", 3)))[0] == 28);
  // The area of a quadratic island stays that of the square: 8ⁿ cells of the grid, by the shoelace formula.
  const Recorder island = drawing("koch-island", 2);
  double area = 0;
  for (const Recorder::Line& line : island.lines)
    area += line.before.position.x * line.after.position.y - line.after.position.x * line.before.position.y;
  CHECK(std::abs(area / 2) == doctest::Approx(16 * 16));
}

TEST_CASE("figures 1.13 to 1.19: curves come to every point of a square or a cube once") {
  struct Filled {
    const char* name;
    std::uint32_t steps;
    Point extent;
  };
  const Filled all[] = {{"hilbert-curve", 5, {32, 32, 1}},
                        {"peano-curve", 3, {27, 27, 1}},
                        {"square-curve-3", 3, {27, 27, 1}},
                        {"square-curve-4", 2, {16, 16, 1}},
                        {"hilbert-cube", 3, {8, 8, 8}}};
  for (const auto& [name, steps, sides] : all) {
    INFO(name);
    const std::vector<Point> points = way(drawing(name, steps));
    CHECK(extent(points) == sides);
    CHECK(points.size() == static_cast<std::size_t>(sides[0] * sides[1] * sides[2]));
    CHECK(different(points) == points.size());
  }
}

TEST_CASE("figures 1.10 and 1.11: edges are drawn once, and curves of the plane come to a point once") {
  const Recorder dragon = drawing("dragon-curve", 10);
  CHECK(dragon.lines.size() == 1024);
  CHECK(different_lines(dragon) == 1024);
  const Recorder gasket = drawing("sierpinski-gasket", 6);
  CHECK(gasket.lines.size() == 729);
  CHECK(different_lines(gasket) == 729);
  // One side of the triangle is 2ⁿ edges long.
  CHECK(glm::length(gasket.lines.back().after.position) == doctest::Approx(64));
  const std::vector<Point> hexagonal = way(drawing("hexagonal-gosper", 4));
  CHECK(hexagonal.size() == 2402);
  CHECK(different(hexagonal) == hexagonal.size());
  // Seven edges stand for one, √7 times as long.
  const Recorder gosper = drawing("hexagonal-gosper", 4);
  CHECK(glm::length(gosper.lines.back().after.position) == doctest::Approx(49));
  const std::vector<Point> quadratic = way(drawing("quadratic-gosper", 2));
  CHECK(quadratic.size() == 626);
  CHECK(different(quadratic) == quadratic.size());
  CHECK(extent(quadratic) == Point{26, 26, 1});
}

TEST_CASE("figure 1.24: branching structures stay in a plane and end where their axis does") {
  for (const char* name : {"plant-a", "plant-b", "plant-c", "plant-d", "plant-e", "plant-f"}) {
    INFO(name);
    const Recorder plant = drawing(name, 4);
    CHECK(plant.lines.size() > 80);
    CHECK(extent(way(plant))[2] == 1);
  }
  // The axis of a is 3ⁿ lines long and straight.
  float highest = 0;
  for (const Recorder::Line& line : drawing("plant-a", 4).lines) highest = std::max(highest, line.after.position.y);
  CHECK(highest == doctest::Approx(81));
}

TEST_CASE("section 1.10: lines' lengths follow their parameters") {
  // Each edge becomes p + 2h + q of itself.
  const double h = std::sqrt(0.3 * 0.7);
  CHECK(length_of(drawing("koch-parametric", 6)) == doctest::Approx(std::pow(1 + 2 * h, 6)).epsilon(1e-4));
  double binary = 0;
  for (int i = 0; i < 10; ++i) binary += std::pow(2 / 1.456, i);
  CHECK(length_of(drawing("binary-tree", 10)) == doctest::Approx(binary).epsilon(1e-4));
  // Row of trees: as the curve, but h and p wait a step and two.
  const Recorder row = drawing("row-of-trees", 10);
  CHECK(row.lines.size() > 200);
  double least = 1;
  for (const Recorder::Line& line : row.lines) least = std::min<double>(least, length_of(line));
  CHECK(least > 0.001);
}

TEST_CASE("chapter 2: trees have the lengths, widths and angles of their tables") {
  const Recorder monopodial = drawing("monopodial-tree", 10);
  // 2.6 a: a trunk of 0.9ⁱ, as thick as 10 · 0.707ⁱ.
  double trunk = 0;
  for (int i = 0; i < 10; ++i) trunk += std::pow(0.9, i);
  float top = 0;
  for (const Recorder::Line& line : monopodial.lines) top = std::max(top, line.after.position.y);
  CHECK(top == doctest::Approx(trunk).epsilon(1e-4));
  CHECK(monopodial.lines.size() == 1023);
  CHECK(monopodial.lines.front().after.width == doctest::Approx(10));
  // Order two branches by 45° from the one before; with $ their left is level, so they lie in the upright plane's
  // normal.
  const Inputs b{{{"r2", 0.9F}}, {}};
  CHECK(length_of(drawing("monopodial-tree", 10, b)) == doctest::Approx([] {
                                                          double sum = 0;
                                                          for (int i = 0; i < 10; ++i) sum += std::pow(1.8, i);
                                                          return sum;
                                                        }())
                                                            .epsilon(1e-4));
  const Recorder sympodial = drawing("sympodial-tree", 10);
  CHECK(length_of(sympodial) == doctest::Approx([] {
                                  double sum = 0;
                                  for (int i = 0; i < 10; ++i) sum += std::pow(1.6, i);
                                  return sum;
                                }())
                                    .epsilon(1e-4));
  // 2.8: the trunk has grown by lr each step.
  const Recorder ternary = drawing("ternary-tree", 6);
  CHECK(ternary.lines.size() == 1 + 2 * (729 - 1));
  CHECK(length_of(ternary.lines.front()) == doctest::Approx(200 * std::pow(1.109, 6)));
  CHECK(ternary.lines.front().after.width == doctest::Approx(std::pow(1.732, 6)).epsilon(1e-3));
  // The tropism points down: bent branches hang lower.
  const auto mean_height = [](const Recorder& of) {
    double sum = 0;
    for (const Recorder::Line& line : of.lines) sum += line.after.position.y;
    return sum / static_cast<double>(of.lines.size());
  };
  const Recorder straight = drawing("ternary-tree", 6, Inputs{{{"e", 0.0F}}, {}});
  const Recorder up = drawing("ternary-tree", 6, Inputs{{{"ty", 1.0F}}, {}});
  CHECK(mean_height(ternary) < mean_height(straight));
  CHECK(mean_height(up) > mean_height(straight));
}

TEST_CASE("chapter 4: florets stand by Vogel’s formula, on a disc and on a cylinder") {
  const Recorder disc = drawing("phyllotaxis-disc", 200);
  REQUIRE(disc.spheres.size() == 200);
  for (std::size_t n = 1; n < disc.spheres.size(); ++n) {
    const vec3 at = disc.spheres[n].turtle.position;
    CHECK(glm::length(at) == doctest::Approx(std::sqrt(static_cast<float>(n))).epsilon(1e-3));
    if (n == 1) continue;
    const vec3 before = disc.spheres[n - 1].turtle.position;
    const float cosine = glm::dot(at, before) / glm::length(at) / glm::length(before);
    CHECK(cosine == doctest::Approx(std::cos(glm::radians(137.5F))).epsilon(1e-3));
  }
  const Recorder cylinder = drawing("phyllotaxis-cylinder", 60);
  REQUIRE(cylinder.spheres.size() == 60);
  for (std::size_t n = 0; n < 60; ++n) {
    const vec3 at = cylinder.spheres[n].turtle.position;
    CHECK(std::hypot(at.x, at.z) == doctest::Approx(500).epsilon(1e-3));
    CHECK(at.y == doctest::Approx(35.3F * static_cast<float>(n)).epsilon(1e-3));
  }
}
