#include "models/bunch/stems.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace panicle;
using namespace panicle::bunch;

namespace {

Internode internode(std::int32_t parent, Kind kind, std::int32_t axis, glm::vec3 start, glm::vec3 end) {
  return {{parent, 0, start, end, 5, 5}, kind, State::grown, axis};
}

}  // namespace

TEST_CASE("a pedicel widens under its berry, a withered one narrows to its tip, an axis does neither") {
  std::vector<Internode> pedicel = {internode(-1, Kind::pedicel, 0, {0, 0, 0}, {0, -60, 0})};
  const auto widest_at_the_tip = [&] {
    const StemMesh stem = sweep_internodes(pedicel, {12}, 1);
    float widest = 0;
    for (std::size_t i = 0; i < stem.mesh.positions.size(); i += 3)
      if (stem.mesh.positions[i + 1] < -55)
        widest = std::max(widest, std::hypot(stem.mesh.positions[i], stem.mesh.positions[i + 2]));
    return widest;
  };
  CHECK(widest_at_the_tip() > 6);
  pedicel[0].state = State::withered;
  CHECK(widest_at_the_tip() < 4);
  pedicel[0].kind = Kind::axis;
  CHECK(widest_at_the_tip() == doctest::Approx(5).epsilon(0.15));
}

TEST_CASE("the rachis and every first-order axis are groups of their own; each vertex knows its internode") {
  const std::vector<Internode> bunch = {
      internode(-1, Kind::rachis, -1, {0, 0, 0}, {0, -50, 0}),
      internode(0, Kind::axis, 0, {0, -50, 0}, {40, -60, 0}),
      internode(0, Kind::rachis, -1, {0, -50, 0}, {0, -100, 0}),
      internode(2, Kind::pedicel, 1, {0, -100, 0}, {-40, -120, 0}),
  };
  const StemMesh stem = sweep_internodes(bunch, {12}, 0.001f);
  REQUIRE(stem.parts.size() == 3);
  for (std::int32_t part = 0; part < 3; ++part) {
    const StemPart& one = stem.parts[static_cast<std::size_t>(part)];
    CHECK(one.group == part - 1);
    for (std::uint32_t i = one.first_vertex; i < one.first_vertex + one.vertex_count; ++i)
      REQUIRE(bunch[stem.segment[i]].axis == one.group);
  }
}

TEST_CASE("a natural stalk whose nodes crowd tapers evenly, without rings") {
  std::vector<Internode> stalk;
  for (int i = 0; i < 24; ++i) {
    Internode one;
    one.parent = i - 1;
    one.kind = Kind::rachis;
    one.axis = -1;
    one.start = {0, -0.5f * static_cast<float>(i), 0};
    one.end = {0, -0.5f * static_cast<float>(i + 1), 0};
    one.radius = 1 - 0.02f * static_cast<float>(i);
    one.radius_end = 1 - 0.02f * static_cast<float>(i + 1);
    stalk.push_back(one);
  }
  // Deviation of the radius from an even taper, between the fourth internode and the twentieth.
  const auto unevenness = [&](bool natural) {
    const Mesh mesh = sweep_internodes(stalk, {12}, 1, natural).mesh;
    float least = 99, most = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
      const float y = mesh.positions[i + 1];
      if (y > -2 || y < -10) continue;
      const float share = std::hypot(mesh.positions[i], mesh.positions[i + 2]) / (1 + 0.04f * y);
      least = std::min(least, share);
      most = std::max(most, share);
    }
    return most - least;
  };
  CHECK(unevenness(true) < 0.012f);
  CHECK(unevenness(false) > 0.035f);
}
