#include "light/plant_sky.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/uv_sphere.hpp"

using namespace panicle;

namespace {

float total(std::span<const SkyBody> specks) {
  float sum = 0;
  for (const SkyBody& speck : specks) sum += speck.square;
  return sum;
}

// A square of 2 × side² triangles with sides of length 1 in the plane y = height, looking up.
Mesh sheet(std::uint32_t side, float height) {
  Mesh mesh;
  for (std::uint32_t i = 0; i <= side; ++i)
    for (std::uint32_t j = 0; j <= side; ++j) {
      const float x = static_cast<float>(i) / static_cast<float>(side) - 0.5f;
      const float z = static_cast<float>(j) / static_cast<float>(side) - 0.5f;
      mesh.positions.insert(mesh.positions.end(), {x, height, z});
      mesh.normals.insert(mesh.normals.end(), {0, 1, 0});
    }
  for (std::uint32_t i = 0; i < side; ++i)
    for (std::uint32_t j = 0; j < side; ++j) {
      const std::uint32_t a = i * (side + 1) + j, b = a + 1, c = a + side + 1, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, c, b, d, c});
    }
  return mesh;
}

}  // namespace

TEST_CASE("the bodies of a stem hide the mean of its silhouettes") {
  const Segment thin{4, 0, {0, 0, 0}, {0, 10, 0}, 0.2f, 0.2f}, thick{-1, 0, {0, 0, 0}, {0, 1, 0}, 1, 0.5f};
  std::vector<SkyBody> specks;
  add_specks(thin, 3, specks);
  CHECK(specks.size() == 4);
  CHECK(total(specks) == doctest::Approx(0.5 * 0.2 * 10));  // surface 2πrl, a quarter of it as a disc: r² = rl / 2
  CHECK(specks.front().centre.y == doctest::Approx(10.0 / 8));
  CHECK(specks.back().centre.y == doctest::Approx(10 - 10.0 / 8));
  CHECK(specks[0].owner == 3);
  CHECK(specks[0].parent == 4);
  specks.clear();
  add_specks(thick, 0, specks);
  CHECK(specks.size() == 1);
  CHECK(specks[0].square == doctest::Approx(0.5 * 0.75));
}

TEST_CASE("a sheet becomes discs that face as it does; a round part becomes balls of a quarter of its surface") {
  std::vector<SkyBody> specks;
  const Mesh leaf = sheet(12, 0);
  add_specks(leaf, whole_range(leaf), 7, specks);
  CHECK(specks.size() >= 16);
  CHECK(specks.size() <= 24);
  CHECK(total(specks) * 3.14159265f == doctest::Approx(1));
  for (const SkyBody& speck : specks) {
    CHECK(std::fabs(speck.facing.y) == doctest::Approx(1));
    CHECK(speck.owner == 7);
  }
  specks.clear();
  const Mesh ball = make_uv_sphere(6);  // so few triangles that each is one speck would be flat
  add_specks(
      ball,
      {0, static_cast<std::uint32_t>(ball.positions.size() / 3), 0, static_cast<std::uint32_t>(ball.indices.size())}, 7,
      specks);
  for (const SkyBody& speck : specks) CHECK(glm::length(speck.facing) == doctest::Approx(1));
}

TEST_CASE("a leaf hides sky from parts below it, and has the sky of the better of its two sides") {
  const Mesh upper = sheet(12, 0.5f), lower = sheet(12, 0);
  std::vector<SkyBody> specks;
  add_specks(upper, whole_range(upper), 0, specks);
  add_specks(lower, whole_range(lower), 1, specks);
  Sky sky({}, specks);
  const std::size_t vertices = lower.positions.size() / 3, middle = vertices / 2;
  std::vector<std::uint8_t> one_side(vertices), both(vertices);
  sample_part(sky, lower, whole_range(lower), 1, false, one_side);
  sample_part(sky, lower, whole_range(lower), 1, true, both);
  CHECK(one_side[middle] < 150);
  CHECK(one_side[0] > one_side[middle]);
  for (std::size_t v = 0; v < vertices; ++v) CHECK(both[v] >= one_side[v]);
  CHECK(both[middle] > one_side[middle] + 50);  // from below it is open
  std::vector<std::uint8_t> top(vertices);
  sample_part(sky, upper, whole_range(upper), 0, false, top);
  CHECK(top[middle] > 200);
}

TEST_CASE("adjacent segments of a stem hide nothing from each other; a ball beside it does, on that side") {
  const std::vector<Segment> segments{{-1, 0, {0, 0, 0}, {0, 1, 0}, 0.1f, 0.1f},
                                      {0, 0, {0, 1, 0}, {0, 2, 0}, 0.1f, 0.1f}};
  const StemMesh stems = sweep_stems({segments}, {}, 1);
  std::vector<SkyBody> specks;
  for (std::int32_t i = 0; i < 2; ++i) add_specks(segments[static_cast<std::size_t>(i)], i, specks);
  Sky alone({}, specks);
  const std::vector<std::uint8_t> open = sky_of_stems(alone, stems, segments);
  CHECK(open.size() == stems.segment.size());
  CHECK(std::all_of(open.begin(), open.end(), [](std::uint8_t byte) { return byte == 255; }));
  const SkyBody ball = sky_ball({0.7f, 1, 0}, 0.5f, 9);
  Sky beside(std::span(&ball, 1), specks);
  const std::vector<std::uint8_t> shaded = sky_of_stems(beside, stems, segments);
  int towards = 255, away = 255;
  for (std::size_t v = 0; v < shaded.size(); ++v) {
    if (std::fabs(stems.mesh.positions[3 * v + 1] - 1) > 0.3f) continue;
    if (stems.mesh.normals[3 * v] > 0.9f) towards = std::min<int>(towards, shaded[v]);
    if (stems.mesh.normals[3 * v] < -0.9f) away = std::min<int>(away, shaded[v]);
  }
  CHECK(towards < 120);
  CHECK(away == 255);
}
