#include "models/bunch/berry/berry_pattern.hpp"

#include <doctest/doctest.h>

#include "mesh/surface.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::test;

TEST_CASE(
    "the pattern is a closed ball of like triangles at every number of "
    "meridians") {
  for (const std::uint32_t meridians : {8u, 11u, 20u, 30u, 54u, 72u, 320u}) {
    CAPTURE(meridians);
    const BerryPattern pattern = make_berry_pattern(meridians);
    Mesh mesh;
    for (std::uint32_t i = 0; i < pattern.vertices; ++i) {
      for (int axis = 0; axis < 3; ++axis) mesh.positions.push_back(pattern.directions[axis][i]);
    }
    mesh.normals = mesh.positions;
    mesh.uvs = pattern.uvs;
    mesh.indices = pattern.indices;
    check_sound(mesh);
    CHECK(share_turned(mesh) == 0);
    const Surface surface = surface_of(mesh, 0, mesh.indices.size());
    CHECK(surface.open_edges == 0);

    double shares = 0, cells = 0;
    float least_cell = 1;
    for (const float share : pattern.shares) shares += share;
    for (const float cell : pattern.cells) {
      cells += cell;
      least_cell = std::min(least_cell, cell);
    }
    CHECK(least_cell > 0);
    CHECK(shares == doctest::Approx(surface.volume).epsilon(1e-4));
    CHECK(cells == doctest::Approx(surface.volume).epsilon(1e-4));
    CHECK(pattern.cells.size() * 3 == pattern.indices.size());
    CHECK(pattern.padded() % 4 == 0);
    CHECK(pattern.padded() >= pattern.vertices);
  }
  CHECK(make_berry_pattern(30).vertices == 425);
}

TEST_CASE("v falls from the tip to the seat and a ring lies where the scar ends") {
  const BerryPattern pattern = make_berry_pattern(30);
  bool scar = false;
  for (std::uint32_t i = 0; i < pattern.vertices; ++i) {
    const double v = pattern.uvs[2 * i + 1];
    const double y = pattern.directions[1][i];
    CHECK(std::acos(std::clamp(-y, -1.0, 1.0)) / 3.14159265358979 == doctest::Approx(v).epsilon(1e-3));
    scar = scar || v == doctest::Approx(0.965).epsilon(1e-4);
    CHECK(pattern.uvs[2 * i] >= 0);
    CHECK(pattern.uvs[2 * i] <= 1);
  }
  CHECK(scar);
}
