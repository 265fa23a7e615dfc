#include "spatial/point_grid.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "foundation/random.hpp"

using namespace panicle;

namespace {

// Points in a ball, on a line, in a plane, at a place, or with a few far away.
std::vector<glm::vec3> random_points(std::uint64_t seed) {
  std::vector<glm::vec3> points(static_cast<std::size_t>(random_integer(seed, 0, 0, 0, 200)));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto unit = [&](std::uint64_t stream) { return random_unit(seed, stream, i) - 0.5f; };
    glm::vec3 p = glm::vec3(unit(1), unit(2), unit(3)) * 20.0f;
    if (seed % 5 == 1) p.y = p.z = 3;
    if (seed % 5 == 2) p.z = -7;
    if (seed % 5 == 3) p = {1, 2, 3};
    if (seed % 5 == 4 && i % 20 == 0) p *= 1000.0f;
    points[i] = p;
  }
  return points;
}

}  // namespace

TEST_CASE("a visit sees every point within an edge's length, as looking at all would, and each once") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const std::vector<glm::vec3> points = random_points(seed);
    const float edge = 0.2f + 4 * random_unit(seed, 9, 0);
    const PointGrid grid(points, edge);
    for (std::uint64_t k = 0; k < 60; ++k) {
      const glm::vec3 at = k < points.size() ? points[k] : 15.0f * random_direction(seed, 10, k);
      std::vector<std::uint32_t> seen;
      grid.visit(at, [&](std::uint32_t i) { seen.push_back(i); });
      const std::set<std::uint32_t> once(seen.begin(), seen.end());
      REQUIRE(once.size() == seen.size());
      for (std::uint32_t i = 0; i < points.size(); ++i)
        if (glm::length(points[i] - at) < 0.999f * edge) REQUIRE(once.count(i) == 1);
    }
  }
}

TEST_CASE("the runs of a box have every point in it, in ascending slots") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const std::vector<glm::vec3> points = random_points(seed);
    const PointGrid grid(points, 0.2f + 4 * random_unit(seed, 9, 0));
    for (std::uint64_t k = 0; k < 30; ++k) {
      const glm::vec3 middle = 10.0f * random_unit(seed, 11, k) * random_direction(seed, 10, k);
      const glm::vec3 half(5 * random_unit(seed, 12, k), 5 * random_unit(seed, 13, k), 5 * random_unit(seed, 14, k));
      std::set<std::uint32_t> seen;
      std::uint32_t before = 0;
      grid.within(middle - half, middle + half, [&](std::uint32_t first, std::uint32_t end) {
        REQUIRE(first >= before);
        REQUIRE(first < end);
        for (std::uint32_t slot = first; slot < end; ++slot) seen.insert(grid.ids()[slot]);
        before = end;
      });
      for (std::uint32_t i = 0; i < points.size(); ++i) {
        const glm::vec3 away = glm::abs(points[i] - middle);
        if (away.x <= half.x && away.y <= half.y && away.z <= half.z) REQUIRE(seen.count(i) == 1);
      }
    }
  }
}

TEST_CASE("visit examines few of many points") {
  std::vector<glm::vec3> points;
  for (std::uint64_t i = 0; i < 8000; ++i)
    points.emplace_back(20 * random_unit(1, 1, i), 20 * random_unit(1, 2, i), 20 * random_unit(1, 3, i));
  const PointGrid grid(points, 1);
  std::uint32_t seen = 0;
  grid.visit({10, 10, 10}, [&](std::uint32_t) { ++seen; });
  CHECK(seen > 10);
  CHECK(seen < 60);  // 27 of the 8000 cells
  seen = 0;
  grid.within({10.1f, 10.1f, 10.1f}, {10.2f, 10.2f, 10.2f},
              [&](std::uint32_t first, std::uint32_t end) { seen += end - first; });
  CHECK(seen < 8);  // one cell
}

TEST_CASE("slots hold each point once, in the same order for the same points; build replaces all points") {
  const std::vector<glm::vec3> points = random_points(5), others = random_points(6);
  PointGrid grid(points, 2);
  std::vector<std::uint32_t> ids(grid.ids().begin(), grid.ids().end());
  PointGrid again(others, 1);
  again.build(points, 2);
  CHECK(std::equal(ids.begin(), ids.end(), again.ids().begin(), again.ids().end()));
  std::sort(ids.begin(), ids.end());
  REQUIRE(ids.size() == points.size());
  for (std::uint32_t i = 0; i < ids.size(); ++i) CHECK(ids[i] == i);
}

TEST_CASE("a point with a coordinate that is not finite is left out") {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    for (const float none : {nan, infinity, -infinity, 2e30f}) {
      std::vector<glm::vec3> points = {{0, 0, 0}, {0.2f, 0.2f, 0.2f}};
      points[1][axis] = none;
      const PointGrid grid(points, 1);
      REQUIRE(grid.ids().size() == 1);
      CHECK(grid.ids()[0] == 0);
    }
}

TEST_CASE("a grid of points that are not finite, of enormous ones and of none is valid") {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  const float most = std::numeric_limits<float>::max();
  const std::vector<glm::vec3> points = {{0, 0, 0},         {nan, 0, 0},         {1, 0, 0},   {0, infinity, 0},
                                         {9e29f, 0, 9e29f}, {-9e29f, 0, -8e29f}, {most, 0, 0}};
  for (const float edge : {1.0f, 1e-30f, 0.0f, nan, infinity}) {
    const PointGrid grid(points, edge);
    CHECK(grid.ids().size() == 4);
    std::set<std::uint32_t> seen;
    grid.visit({0, 0, 0}, [&](std::uint32_t i) { seen.insert(i); });
    CHECK(seen.count(0) == 1);
    CHECK(seen.count(1) + seen.count(3) + seen.count(6) == 0);
    for (const glm::vec3& at : {glm::vec3(nan), glm::vec3(infinity), glm::vec3(-most), glm::vec3(most)})
      grid.visit(at, [](std::uint32_t) {});
  }
  std::uint32_t seen = 0;
  const auto count = [&](std::uint32_t) { ++seen; };
  PointGrid({}, 1).visit({0, 0, 0}, count);
  PointGrid().visit({0, 0, 0}, count);
  PointGrid(std::vector<glm::vec3>{glm::vec3(nan)}, 1).visit({0, 0, 0}, count);
  CHECK(seen == 0);
}
