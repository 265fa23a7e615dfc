// The grid against every sphere in turn: same contacts, same force, to the last bit.

#include "spatial/sphere_grid.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "foundation/bits.hpp"
#include "foundation/random.hpp"

using namespace panicle;

namespace {

constexpr glm::vec3 up{0, 1, 0};
constexpr std::uint32_t none = SphereGrid::no_sphere;
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

// Equation 1 over all spheres in the order of their ids.
Push push_of_all(const std::vector<Sphere>& spheres, const Sphere& probe, std::uint32_t except, const glm::vec3& tie) {
  double force[3] = {0, 0, 0};
  std::uint32_t contacts = 0;
  for (std::uint32_t id = 0; id < spheres.size(); ++id) {
    if (id == except) continue;
    double away[3], square = 0;
    for (int axis = 0; axis < 3; ++axis) {
      away[axis] = double{probe.centre[axis]} - spheres[id].centre[axis];
      square += away[axis] * away[axis];
    }
    const double reach = (double{probe.radius} + spheres[id].radius) * 1.00001;
    const double distance = std::sqrt(square);
    if (!(square < reach * reach)) continue;
    const double share = std::min((reach - distance) / (2.0 * probe.radius), 1e6);
    for (int axis = 0; axis < 3; ++axis) {
      force[axis] += distance > 0 ? away[axis] * (share / distance) : tie[axis] * share;
    }
    ++contacts;
  }
  Push push;
  push.contacts = contacts;
  if (contacts > 0) {
    push.force = {static_cast<float>(force[0] / contacts), static_cast<float>(force[1] / contacts),
                  static_cast<float>(force[2] / contacts)};
  }
  return push;
}

struct Cloud {
  const char* name;
  float largest;  // passed to the grid
  float smallest_radius, largest_radius;
  float extent;  // of the cube of centres
  glm::vec3 middle;
};

Sphere sphere_of(const Cloud& cloud, std::uint64_t stream, std::uint64_t i) {
  const auto unit = [&](std::uint64_t part) { return random_unit(stream, part, i); };
  const float span = cloud.largest_radius - cloud.smallest_radius;
  return {cloud.middle + (glm::vec3(unit(1), unit(2), unit(3)) - 0.5f) * cloud.extent,
          cloud.smallest_radius + span * unit(4) * unit(5)};
}

}  // namespace

TEST_CASE("probe equals a search through all spheres") {
  const Cloud clouds[] = {
      {"a bunch", 30, 5, 30, 300, {0, -300, 0}},
      {"radii of 7 and of 80", 80, 7, 80, 900, {0, 0, 0}},
      {"one cell", 30, 1, 30, 20, {37, 37, 37}},
      {"cell borders", 30, 30, 30, 240, {0, 0, 0}},
      {"far away", 30, 10, 30, 200, {1e6f, -2e6f, 3e6f}},
      {"beyond the last cell", 1e-3f, 1, 30, 200, {1e9f, 1e9f, -1e9f}},
      {"larger than announced", 2, 5, 60, 600, {0, 0, 0}},
      {"in metres", 0.0075f, 0.0015f, 0.0075f, 0.1f, {0, -0.1f, 0}},
      {"tiny", 1e-25f, 1e-26f, 1e-25f, 1e-24f, {0, 0, 0}},
      {"huge", 1e30f, 1e28f, 1e30f, 1e31f, {0, 0, 0}},
  };
  for (const Cloud& cloud : clouds) {
    CAPTURE(cloud.name);
    SphereGrid grid(cloud.largest);
    std::vector<Sphere> spheres;
    std::uint32_t touched = 0, free = 0;
    for (std::uint32_t i = 0; i < 400; ++i) {
      Sphere probe = sphere_of(cloud, 11, i);
      for (std::uint32_t attempt = 0; attempt < 6; ++attempt) {
        // Over and over in the same place, as a newborn does, and now and then on a cell's border or on top of another.
        if (attempt == 3 && !spheres.empty()) probe.centre = spheres[i / 2].centre;
        if (attempt == 4) probe.centre = {cloud.largest * 2, cloud.largest * -4, 0};
        const std::uint32_t except = attempt % 2 == 0 ? i / 3 : none;
        const glm::vec3 tie = random_direction(1, 2, i);
        const Push got = grid.probe(probe, except, tie);
        const Push want = push_of_all(spheres, probe, except, tie);
        REQUIRE(got.contacts == want.contacts);
        REQUIRE(got.force == want.force);
        (got.contacts > 0 ? touched : free) += 1;
        probe.centre += random_direction(3, attempt, i) * probe.radius * 0.3f;
      }
      const Sphere next = sphere_of(cloud, 12, i);
      REQUIRE(grid.add(next) == i);
      spheres.push_back(next);
    }
    CHECK(touched > 100);
    CHECK(free > 10);
    CHECK(grid.spheres().size() == spheres.size());
  }
}

TEST_CASE("spheres overlap within the clearance and not beyond") {
  SphereGrid grid(30);
  grid.add({{0, 0, 0}, 20});
  CHECK(grid.probe({{30, 0, 0}, 10}, none, up).contacts == 1);
  CHECK(grid.probe({{30.0002f, 0, 0}, 10}, none, up).contacts == 1);
  CHECK(grid.probe({{30.0004f, 0, 0}, 10}, none, up).contacts == 0);
  CHECK(grid.probe({{29, 0, 0}, 10}, none, up).contacts == 1);
}

TEST_CASE("the push points away from the obstacle, by depth over diameter, on average over contacts") {
  SphereGrid grid(30);
  grid.add({{0, 0, 0}, 20});
  const Push one = grid.probe({{0, 0, 25}, 10}, none, up);
  CHECK(one.contacts == 1);
  CHECK(one.force.x == 0);
  CHECK(one.force.z == doctest::Approx(5.0 / 20).epsilon(1e-4));
  grid.add({{0, 0, 50}, 20});
  const Push two = grid.probe({{0, 0, 25}, 10}, none, up);
  CHECK(two.contacts == 2);
  CHECK(std::fabs(two.force.z) < 1e-6f);
  CHECK(grid.probe({{0, 0, 25}, 10}, 1, up).force == one.force);
}

TEST_CASE("a centre on a centre is pushed along the tie; a point's push is finite") {
  SphereGrid grid(30);
  grid.add({{1, 2, 3}, 20});
  const Push same = grid.probe({{1, 2, 3}, 10}, none, {0, 0, -1});
  CHECK(same.force.x == 0);
  CHECK(same.force.z == doctest::Approx(-1.5).epsilon(1e-4));
  const Push point = grid.probe({{1, 2, 4}, 0}, none, up);
  CHECK(point.contacts == 1);
  CHECK(point.force == glm::vec3(0, 0, 1e6f));
}

TEST_CASE("add refuses spheres that are not finite, and such probes touch nothing") {
  SphereGrid grid(30);
  CHECK(grid.add({{0, 0, 0}, 20}) == 0);
  CHECK(grid.add({{not_a_number, 0, 0}, 20}) == none);
  CHECK(grid.add({{0, infinity, 0}, 20}) == none);
  CHECK(grid.add({{0, 0, 0}, infinity}) == none);
  CHECK(grid.add({{0, 0, 0}, not_a_number}) == none);
  CHECK(grid.add({{0, 0, 0}, -1}) == none);
  CHECK(grid.spheres().size() == 1);
  CHECK(grid.probe({{not_a_number, 0, 0}, 20}, none, up).contacts == 0);
  CHECK(grid.probe({{0, 0, -infinity}, 20}, none, up).contacts == 0);
  CHECK(grid.probe({{0, 0, 0}, infinity}, none, up).contacts == 0);
  CHECK(grid.probe({{0, 0, 0}, not_a_number}, none, up).contacts == 0);
  CHECK(grid.probe({{0, 0, 0}, 1}, none, up).contacts == 1);
}

TEST_CASE("a grid works for any `largest`") {
  for (const float largest : {0.0f, -3.0f, infinity, not_a_number, 1e-40f, 3e38f}) {
    SphereGrid grid(largest);
    CHECK(grid.probe({{0, 0, 0}, 1}, none, up).contacts == 0);
    CHECK(grid.add({{0, 0, 0}, 20}) == 0);
    CHECK(grid.add({{500, 0, 0}, 40}) == 1);
    CHECK(grid.probe({{25, 0, 0}, 10}, none, up).contacts == 1);
    CHECK(grid.probe({{465, 0, 0}, 30}, none, up).contacts == 1);
    CHECK(grid.probe({{250, 0, 0}, 30}, none, up).contacts == 0);
  }
}

TEST_CASE("a sphere added near the last probe is found by the next") {
  SphereGrid grid(30);
  for (std::uint32_t i = 0; i < 50; ++i) {
    CHECK(grid.probe({{0, 0, 0}, 30}, none, up).contacts == i);
    grid.add({{1, 0, 0}, 30});
  }
}

TEST_CASE("results are frozen: contacts and force of a fixed cloud") {
  SphereGrid grid(30);
  const Cloud cloud{"a bunch", 30, 5, 30, 300, {0, -300, 0}};
  for (std::uint32_t i = 0; i < 200; ++i) grid.add(sphere_of(cloud, 12, i));
  const Push push = grid.probe({{10, -290, 5}, 30}, none, up);
  CHECK(push.contacts == 3);
  CHECK(bit_cast<std::uint32_t>(push.force.x) == 0x3c03f3f7u);
  CHECK(bit_cast<std::uint32_t>(push.force.y) == 0xbdca7130u);
  CHECK(bit_cast<std::uint32_t>(push.force.z) == 0x3c7add80u);
}
