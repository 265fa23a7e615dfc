#include "models/bunch/foliage/leaf.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "foundation/english.hpp"
#include "foundation/fingerprint.hpp"
#include "foundation/random.hpp"
#include "mesh/surface.hpp"
#include "models/bunch/foliage/flat_leaf.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::test;
using namespace panicle::tests;

namespace {

Mesh leaf_of(const LeafOptions& options) { return make_leaf(flat_leaf(), options); }

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

double mean_up(const Mesh& mesh) {
  double up = 0;
  for (std::size_t i = 2; i < mesh.normals.size(); i += 3) up += mesh.normals[i];
  return 3 * up / static_cast<double>(mesh.normals.size());
}

// Whether the leaf is mirrored: a point at the right of the flat leaf is at the left.
bool is_mirrored(const Mesh& leaf) {
  const auto right = static_cast<std::uint32_t>(1 + (flat_leaf_rings - 1) * (flat_leaf_parts + 1) + 40);
  return leaf.positions[3 * right] < 0;
}

}  // namespace

TEST_CASE("a leaf is one sound sheet with one edge, for any seed, opening and wilting") {
  int mirrored = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    const Mesh leaf = leaf_of({seed, random_unit(seed, 1, 0), random_unit(seed, 1, 1)});
    check_sound(leaf);
    CHECK(surface_of(leaf, 0, leaf.indices.size()).open_edges == flat_leaf_parts + 2 * flat_leaf_rings);
    CHECK(share_turned(leaf) < 0.02);
    CHECK(position_of(leaf, 0) == glm::dvec3(0));
    mirrored += is_mirrored(leaf);
    // Mirrored or not, the upper face looks up.
    CHECK(mean_up(leaf) > 0.3);
  }
  CHECK(mirrored > 60);
  CHECK(mirrored < 140);
}

TEST_CASE("texture coordinates and the order of vertices are the flat leaf's") {
  const FlatLeaf flat = flat_leaf();
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Mesh leaf = leaf_of({seed});
    CHECK(leaf.uvs == std::vector<float>(flat.uvs.begin(), flat.uvs.end()));
    CHECK(leaf.positions.size() == 3 * flat.between.size());
    CHECK(leaf.indices.size() == flat.triangles.size());
  }
}

TEST_CASE("between veins the blade is puckered upwards") {
  LeafNumbers veined = make_flat_leaf(), plain = veined;
  plain.between.assign(plain.between.size(), 0);
  int higher = 0, raised = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Mesh one = make_leaf(veined.view(), {seed}), other = make_leaf(plain.view(), {seed});
    for (std::size_t i = 0; i < veined.between.size(); ++i) {
      if (veined.between[i] < 0.5f || i < flat_leaf_parts) continue;
      ++raised;
      higher += one.positions[3 * i + 2] > other.positions[3 * i + 2] + 0.005f;
    }
  }
  CHECK(higher == doctest::Approx(raised).epsilon(0.05));
}

TEST_CASE("a leaf opens: from folded along the midrib to spread, its surface nearly the same") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    const auto width = [&](float opening) {
      const Mesh leaf = leaf_of({seed, opening});
      double least = 0, most = 0;
      for (std::size_t i = 0; i < leaf.positions.size(); i += 3) {
        least = std::min<double>(least, leaf.positions[i]);
        most = std::max<double>(most, leaf.positions[i]);
      }
      return most - least;
    };
    CHECK(width(0) < 0.85 * width(1));
    CHECK(width(0.2f) < width(1));
    CHECK(area(leaf_of({seed, 0})) == doctest::Approx(area(leaf_of({seed, 1}))).epsilon(0.12));
  }
}

TEST_CASE("spread leaves look up, wilting ones hang") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Mesh fresh = leaf_of({seed}), wilted = leaf_of({seed, 1, 1});
    CHECK(mean_up(fresh) > 0.7);
    double lowest = 0, lowest_wilted = 0;
    for (std::size_t i = 2; i < fresh.positions.size(); i += 3) {
      lowest = std::min<double>(lowest, fresh.positions[i]);
      lowest_wilted = std::min<double>(lowest_wilted, wilted.positions[i]);
    }
    CHECK(lowest_wilted < lowest - 0.1);
  }
}

TEST_CASE("each seed gives a leaf of its own, always the same; options out of range are clamped") {
  const Mesh third = leaf_of({3});
  CHECK(leaf_of({4}).positions != third.positions);
  CHECK(leaf_of({3}).positions == third.positions);
  CHECK(leaf_of({3, 9, -4}).positions == leaf_of({3, 1, 0}).positions);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(leaf_of({3, nan, nan}).positions == leaf_of({3, 0, 0}).positions);
}

TEST_CASE("invalid numbers of a leaf are refused with a message") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(check({}).reason == Reason::none);
  CHECK(check(flat_leaf()).reason == Reason::none);
  const auto spoiled = [](auto&& spoil) {
    LeafNumbers leaf = make_flat_leaf();
    spoil(leaf);
    const Diagnostic trouble = check(leaf.view());
    CHECK(trouble.reason == Reason::bad_request);
    return english(trouble.message);
  };
  CHECK(spoiled([](LeafNumbers& leaf) { leaf.points.pop_back(); }).find("lengths") != std::string::npos);
  CHECK(spoiled([](LeafNumbers& leaf) { leaf.between.pop_back(); }).find("lengths") != std::string::npos);
  CHECK(spoiled([](LeafNumbers& leaf) { leaf.uvs.clear(); }).find("lengths") != std::string::npos);
  CHECK(spoiled([](LeafNumbers& leaf) { leaf.triangles.pop_back(); }).find("lengths") != std::string::npos);
  CHECK(spoiled([](LeafNumbers& leaf) { leaf.petiole = {0.3f}; }).find("lengths") != std::string::npos);
  CHECK(spoiled([](LeafNumbers& leaf) { leaf.petiole = {0.3f, -1}; }).find("points") != std::string::npos);
  CHECK(spoiled([&](LeafNumbers& leaf) { leaf.points[4] = nan; }).find("points") != std::string::npos);
  CHECK(spoiled([](LeafNumbers& leaf) { leaf.points[4] = 1e9f; }).find("points") != std::string::npos);
  CHECK(spoiled([](LeafNumbers& leaf) { leaf.between[4] = 2; }).find("points") != std::string::npos);
  CHECK(spoiled([](LeafNumbers& leaf) { leaf.uvs[4] = -0.1f; }).find("points") != std::string::npos);
  CHECK(spoiled([](LeafNumbers& leaf) {
          leaf.triangles[4] = static_cast<std::uint32_t>(leaf.between.size());
        }).find("triangle") != std::string::npos);
}

TEST_CASE("points of no triangle have a normal, too") {
  const LeafNumbers leaf{{0, 0, 1, 0, 0, 1, 1, 1}, {0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0}, {0, 1, 2}};
  const Mesh mesh = make_leaf(leaf.view(), {1});
  REQUIRE(mesh.normals.size() >= 12);
  for (std::size_t i = 0; i + 2 < mesh.normals.size(); i += 3)
    CHECK(std::hypot(mesh.normals[i], mesh.normals[i + 1], mesh.normals[i + 2]) == doctest::Approx(1));
}

TEST_CASE("numbers of a fixed leaf") {
  const LeafNumbers square{
      {0, 0, 0.5f, 0.5f, 0, 1, -0.5f, 0.5f}, {0, 1, 0, 1}, {0, 0, 1, 0, 1, 1, 0, 1}, {0, 1, 2, 0, 2, 3}};
  const Mesh leaf = make_leaf(square.view(), {1});
  Fingerprint fingerprint;  // the same on all toolchains
  fingerprint.add(std::span<const float>(leaf.positions));
  fingerprint.add(std::span<const float>(leaf.normals));
  fingerprint.add(std::span<const std::uint32_t>(leaf.indices));
  CHECK(fingerprint.value() == 0xc54689e303d4230bu);
}
