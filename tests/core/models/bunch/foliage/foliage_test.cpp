#include "models/bunch/foliage/foliage.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "foundation/fingerprint.hpp"
#include "foundation/random.hpp"
#include "mesh/surface.hpp"
#include "models/bunch/foliage/flat_leaf.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::test;
using namespace panicle::tests;
using PartKind = FoliagePart::Kind;

namespace {

const FoliageOptions ripe{1, 5, true, 100, {0, 0.04f, 0}, 0.12f, flat_leaf()};

std::vector<glm::dvec3> points_of(const Foliage& foliage, const FoliagePart& part) {
  std::vector<glm::dvec3> points;
  for (std::uint32_t i = 0; i < part.vertex_count; ++i)
    points.push_back(position_of(foliage.mesh, part.first_vertex + i));
  return points;
}

std::vector<FoliagePart> parts_of(const Foliage& foliage, PartKind kind) {
  std::vector<FoliagePart> parts;
  for (const FoliagePart& part : foliage.parts)
    if (part.kind == kind) parts.push_back(part);
  return parts;
}

// Checks that foliage is sound, its parts cover it in order, share no triangles, tubes are closed, and it is within the
// budget.
void check_foliage(const Foliage& foliage, std::uint32_t leaves) {
  check_sound(foliage.mesh);
  std::uint32_t vertex = 0, index = 0;
  for (const FoliagePart& part : foliage.parts) {
    CHECK(part.first_vertex == vertex);
    CHECK(part.first_index == index);
    REQUIRE(part.index_count > 0);
    const auto first = foliage.mesh.indices.begin() + index;
    CHECK(std::all_of(first, first + part.index_count,
                      [&](std::uint32_t i) { return i >= vertex && i < vertex + part.vertex_count; }));
    const std::size_t open = surface_of(foliage.mesh, index, part.index_count).open_edges;
    if (part.kind == PartKind::leaf) CHECK(part.vertex_count <= 900);
    if (part.kind == PartKind::cane) CHECK(part.vertex_count <= 600);
    CHECK((part.kind == PartKind::leaf) == (open > 0));
    vertex += part.vertex_count;
    index += part.index_count;
  }
  CHECK(vertex * 3 == foliage.mesh.positions.size());
  CHECK(index == foliage.mesh.indices.size());
  CHECK(parts_of(foliage, PartKind::cane).size() == 1);
  CHECK(parts_of(foliage, PartKind::leaf).size() == leaves);
  CHECK(parts_of(foliage, PartKind::petiole).size() == leaves);
}

FoliageOptions any_options(std::uint64_t i) {
  FoliageOptions options;
  options.seed = random_bits(i, 1, 0);
  options.leaves = static_cast<std::uint32_t>(random_integer(i, 1, 1, 1, 5));
  options.cane = i % 2 == 0;
  options.age = 125 * random_unit(i, 1, 2);
  options.foot = {0, 0.03f + 0.1f * random_unit(i, 1, 3), 0};
  options.bunch_width = 0.24f * random_unit(i, 1, 4);
  options.leaf = flat_leaf();
  return options;
}

// Greatest distance between two points.
double extent_of(const std::vector<glm::dvec3>& points) {
  double most = 0;
  for (const glm::dvec3& a : points)
    for (const glm::dvec3& b : points) most = std::max(most, glm::length(a - b));
  return most;
}

}  // namespace

TEST_CASE("no foliage grows unless requested; leaves come with the cane") {
  CHECK(grow_foliage({}).parts.empty());
  CHECK(grow_foliage({}).mesh.indices.empty());
  check_foliage(grow_foliage({1, 0, true}), 0);
  check_foliage(grow_foliage({1, 3, false, 100, {0, 0.04f, 0}, 0, flat_leaf()}), 3);
  check_foliage(grow_foliage({1, 500, true, 100, {0, 0.04f, 0}, 0, flat_leaf()}), 5);
  // There are no leaves without a leaf shape.
  check_foliage(grow_foliage({1, 3, false}), 0);
}

TEST_CASE("foliage of any seed, age and width is sound and does not hide the bunch") {
  for (std::uint64_t i = 0; i < 150; ++i) {
    CAPTURE(i);
    const FoliageOptions options = any_options(i);
    const Foliage foliage = grow_foliage(options);
    check_foliage(foliage, options.leaves);
    const double radius = options.bunch_width / 2;
    for (const FoliagePart& part : parts_of(foliage, PartKind::leaf)) {
      for (const glm::dvec3& p : points_of(foliage, part)) {
        const bool in_the_bunch = p.y < 0 && std::hypot(p.x, p.z) < radius;
        const bool before_it = p.y < 0 && p.z > 0 && std::fabs(p.x) < radius;
        REQUIRE(!in_the_bunch);
        REQUIRE(!before_it);
        REQUIRE(glm::length(p - glm::dvec3(options.foot)) < 0.45);
      }
    }
  }
}

TEST_CASE("cane: 17 to 24 cm long, 6 to 9 mm thick between its ends, thicker at its nodes, across the bunch") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    FoliageOptions options = ripe;
    options.seed = seed;
    const Foliage foliage = grow_foliage(options);
    const std::vector<glm::dvec3> cane = points_of(foliage, parts_of(foliage, PartKind::cane)[0]);
    double left = 0, right = 0;
    for (const glm::dvec3& p : cane) {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
      CHECK(p.y > 0);
    }
    CHECK(left < -0.08);
    CHECK(left > -0.125);
    CHECK(right > 0.08);
    CHECK(right < 0.125);
    // Rings of 13 vertices: their diameters are twice the distance from the middle.
    double thinnest = 1, thickest = 0;
    for (std::size_t ring = 3; ring + 3 < (cane.size() - 2) / 13; ++ring) {
      const glm::dvec3* p = &cane[1 + 13 * ring];
      const double diameter = glm::length(p[0] - p[6]);
      thinnest = std::min(thinnest, diameter);
      thickest = std::max(thickest, diameter);
    }
    CHECK(thinnest > 0.0045);
    CHECK(thickest < 0.0095);
    CHECK(thickest > 1.1 * thinnest);
  }
}

TEST_CASE("the cane goes through the foot of the peduncle at any place") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    FoliageOptions options = ripe;
    options.seed = seed;
    options.foot = {0.004f, 0.03f + 0.001f * static_cast<float>(seed), -0.003f};
    const Foliage foliage = grow_foliage(options);
    double near = 1;
    for (const glm::dvec3& p : points_of(foliage, parts_of(foliage, PartKind::cane)[0]))
      near = std::min(near, glm::length(p - glm::dvec3(options.foot)));
    CHECK(near < 0.006);
  }
}

TEST_CASE("leaves: 8 to 14 cm when grown, smaller at flowering, larger on a larger bunch, petioles at their bases") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    const auto extents = [&](float age, float width) {
      FoliageOptions options = ripe;
      options.seed = seed;
      options.age = age;
      options.bunch_width = width;
      const Foliage foliage = grow_foliage(options);
      const std::vector<FoliagePart> leaves = parts_of(foliage, PartKind::leaf);
      const std::vector<FoliagePart> petioles = parts_of(foliage, PartKind::petiole);
      std::vector<double> found;
      for (std::size_t k = 0; k < leaves.size(); ++k) {
        const glm::dvec3 base = position_of(foliage.mesh, leaves[k].first_vertex);
        double gap = 1;
        for (const glm::dvec3& p : points_of(foliage, petioles[k])) gap = std::min(gap, glm::length(p - base));
        CHECK(gap < 0.003);
        found.push_back(extent_of(points_of(foliage, leaves[k])));
      }
      return found;
    };
    const std::vector<double> grown = extents(80, 0.12f), young = extents(0, 0.12f), large = extents(80, 0.2f);
    for (std::size_t k = 0; k < 5; ++k) {
      CHECK(grown[k] > 0.07);
      CHECK(grown[k] < 0.17);
      CHECK(young[k] < 0.8 * grown[k]);
      CHECK(large[k] >= grown[k]);
    }
  }
}

TEST_CASE("another leaf changes no other leaf, and a small change of age makes a small change") {
  const auto leaf = [](const FoliageOptions& options, std::size_t k) {
    const Foliage foliage = grow_foliage(options);
    return points_of(foliage, parts_of(foliage, PartKind::leaf)[k]);
  };
  FoliageOptions fewer = ripe;
  fewer.leaves = 3;
  for (std::size_t k = 0; k < 3; ++k) CHECK(leaf(fewer, k) == leaf(ripe, k));
  for (float age = 0; age < 125; age += 2.5f) {
    FoliageOptions now = ripe, later = ripe;
    now.age = age;
    later.age = age + 0.01f;
    for (std::size_t k = 0; k < 5; ++k) {
      const std::vector<glm::dvec3> a = leaf(now, k), b = leaf(later, k);
      double furthest = 0;
      for (std::size_t i = 0; i < a.size(); ++i) furthest = std::max(furthest, glm::length(a[i] - b[i]));
      CHECK(furthest < 0.0005);
    }
  }
}

TEST_CASE("seeds differ, leaves of one shoot differ, the same seed gives the same bytes") {
  FoliageOptions other = ripe;
  other.seed = 2;
  const Foliage foliage = grow_foliage(ripe);
  CHECK(grow_foliage(other).mesh.positions != foliage.mesh.positions);
  CHECK(grow_foliage(ripe).mesh.positions == foliage.mesh.positions);  // independent of growth in between
  const std::vector<FoliagePart> leaves = parts_of(foliage, PartKind::leaf);
  for (std::size_t k = 1; k < leaves.size(); ++k)
    CHECK(extent_of(points_of(foliage, leaves[k])) != doctest::Approx(extent_of(points_of(foliage, leaves[0]))));
}

TEST_CASE("NaN and numbers out of range are clamped") {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  for (const float value : {nan, infinity, -infinity, -1.0f, 1e30f}) {
    CAPTURE(value);
    check_foliage(grow_foliage({3, 5, true, value, glm::vec3(value), value, flat_leaf()}), 5);
  }
}

TEST_CASE("numbers of a fixed shoot") {
  const Foliage foliage = grow_foliage(ripe);
  Fingerprint fingerprint;  // the same on all toolchains
  fingerprint.add(std::span<const float>(foliage.mesh.positions));
  fingerprint.add(std::span<const float>(foliage.mesh.normals));
  fingerprint.add(std::span<const float>(foliage.mesh.uvs));
  fingerprint.add(std::span<const std::uint32_t>(foliage.mesh.indices));
  CHECK(fingerprint.value() == 0xbc114b2b6f63cdbdu);
}
