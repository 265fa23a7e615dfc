#include "models/bunch/foliage/leaf.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "foundation/fingerprint.hpp"
#include "foundation/random.hpp"
#include "geometry/surface.hpp"
#include "models/bunch/foliage/leaf_outline.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::test;

namespace {

struct Polar {
  double away, degrees;
};

// A vertex's place in the flat blade, from its texture coordinates.
Polar flat(const Mesh& leaf, std::uint32_t vertex) {
  const double x = (leaf.uvs[2 * vertex] - leaf_petiole_u) / leaf_chart_scale;
  const double y = (leaf.uvs[2 * vertex + 1] - leaf_petiole_v) / leaf_chart_scale;
  return {std::hypot(x, y), std::atan2(x, y) * 57.29577951308232};
}

// The margin comes last, from the left end of the petiole sinus to the right.
std::vector<Polar> margin(const Mesh& leaf) {
  const auto vertices = static_cast<std::uint32_t>(leaf.positions.size() / 3);
  std::vector<Polar> points;
  for (std::uint32_t i = vertices - 4 * leaf_teeth * leaf_sectors - 1; i < vertices; ++i)
    points.push_back(flat(leaf, i));
  return points;
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const glm::dvec3 a = position_of(mesh, mesh.indices[t]);
    sum += glm::length(
               glm::cross(position_of(mesh, mesh.indices[t + 1]) - a, position_of(mesh, mesh.indices[t + 2]) - a)) /
           2;
  }
  return sum;
}

}  // namespace

TEST_CASE("a leaf is one sound sheet with one edge, for any seed, opening and wilting") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    const float opening = random_unit(seed, 1, 0), wilting = random_unit(seed, 1, 1);
    const Mesh leaf = make_leaf({seed, opening, wilting});
    check_sound(leaf);
    CHECK(leaf.positions.size() / 3 == 568);
    // All along the margin, and down both sides of the petiole sinus.
    CHECK(surface_of(leaf, 0, leaf.indices.size()).open_edges == 4 * leaf_teeth * leaf_sectors + 2 * 9);
    CHECK(share_turned(leaf) < 0.02);
    for (const float coordinate : leaf.uvs) {
      REQUIRE(coordinate >= 0);
      REQUIRE(coordinate <= 1);
    }
    CHECK(position_of(leaf, 0) == glm::dvec3(0));
    CHECK(flat(leaf, 0).away < 1e-6);
  }
}

TEST_CASE("five lobes: the veins' ends lie further out than the bays beside them, the midrib's furthest") {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    const LeafOutline outline(seed);
    for (std::uint32_t sector = 1; sector < 5; ++sector) {
      const float tips = std::min(outline.radius(sector, 0), outline.radius(sector, 1));
      float bay = 1;
      for (int i = 1; i < 20; ++i) bay = std::min(bay, outline.radius(sector, static_cast<float>(i) / 20));
      CHECK(bay < 0.97f * tips);
      CHECK(bay > 0.4f);
    }
    for (std::uint32_t sector = 0; sector < 5; ++sector) {
      CHECK(outline.radius(sector, 1) == doctest::Approx(outline.radius(sector + 1, 0)));
      CHECK(outline.angle(sector, 1) == doctest::Approx(outline.angle(sector + 1, 0)));
    }
    CHECK(outline.radius(3, 0) == doctest::Approx(1));
    CHECK(outline.angle(3, 1) == leaf_upper_vein);
    CHECK(outline.angle(4, 1) == leaf_lower_vein);
    CHECK(outline.angle(1, 0) == -leaf_lower_vein);
  }
}

TEST_CASE("the margin is toothed, but entire towards the petiole sinus, and turns always onwards") {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    const std::vector<Polar> points = margin(make_leaf({seed}));
    int teeth = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      CHECK(points[i].degrees > points[i - 1].degrees);
      if (points[i].away > points[i - 1].away && points[i].away > points[i + 1].away) ++teeth;
    }
    CHECK(teeth >= 36);
    CHECK(teeth <= 48);
    // The sinus is open, and the blade wider than it is long from the petiole.
    CHECK(points.front().degrees < -150);
    CHECK(points.back().degrees > 150);
    CHECK(points.back().degrees - points.front().degrees < 346);
  }
}

TEST_CASE("veins run straight in the chart: there are vertices on each of the five, all the way") {
  const Mesh leaf = make_leaf({7});
  for (const float vein : {-leaf_lower_vein, -leaf_upper_vein, 0.0f, leaf_upper_vein, leaf_lower_vein}) {
    int on_it = 0;
    for (std::uint32_t i = 1; i < leaf.positions.size() / 3; ++i)
      on_it += std::fabs(flat(leaf, i).degrees - vein) < 0.01 ? 1 : 0;
    CHECK(on_it == 9);
  }
}

TEST_CASE("a leaf opens: from folded along the midrib to spread, its surface nearly the same") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto width = [&](float opening) {
      const Mesh leaf = make_leaf({seed, opening});
      double least = 0, most = 0;
      for (std::size_t i = 0; i < leaf.positions.size(); i += 3) {
        least = std::min<double>(least, leaf.positions[i]);
        most = std::max<double>(most, leaf.positions[i]);
      }
      return most - least;
    };
    CHECK(width(0) < 0.8 * width(1));
    CHECK(width(0.5f) < width(1));
    CHECK(width(1) > 1.05);
    CHECK(width(1) < 1.75);
    CHECK(area(make_leaf({seed, 0})) == doctest::Approx(area(make_leaf({seed, 1}))).epsilon(0.12));
  }
}

TEST_CASE("spread leaves look up, wilting ones hang") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Mesh fresh = make_leaf({seed}), wilted = make_leaf({seed, 1, 1});
    double up = 0;
    for (std::size_t i = 2; i < fresh.normals.size(); i += 3) up += fresh.normals[i];
    CHECK(up / (static_cast<double>(fresh.normals.size()) / 3) > 0.7);
    double lowest = 0, lowest_wilted = 0;
    for (std::size_t i = 2; i < fresh.positions.size(); i += 3) {
      lowest = std::min<double>(lowest, fresh.positions[i]);
      lowest_wilted = std::min<double>(lowest_wilted, wilted.positions[i]);
    }
    CHECK(lowest_wilted < lowest - 0.1);
  }
}

TEST_CASE("each seed is another leaf, the same one every time; options out of range count as the nearest") {
  const Mesh third = make_leaf({3});
  CHECK(make_leaf({4}).uvs != third.uvs);
  CHECK(make_leaf({3}).positions == third.positions);
  CHECK(make_leaf({3, 9, -4}).positions == make_leaf({3, 1, 0}).positions);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(make_leaf({3, nan, nan}).positions == make_leaf({3, 0, 0}).positions);
}

TEST_CASE("numbers of a fixed leaf") {
  const Mesh leaf = make_leaf({1});
  CHECK(leaf.indices.size() / 3 == 924);
  CHECK(area(leaf) == doctest::Approx(1.3).epsilon(0.3));
  Fingerprint fingerprint;  // changes when leaves are shaped anew, never between toolchains
  fingerprint.add(std::span<const float>(leaf.positions));
  fingerprint.add(std::span<const float>(leaf.normals));
  fingerprint.add(std::span<const float>(leaf.uvs));
  fingerprint.add(std::span<const std::uint32_t>(leaf.indices));
  CHECK(fingerprint.value() == 0xfc27f19d0a68bd21u);
}
