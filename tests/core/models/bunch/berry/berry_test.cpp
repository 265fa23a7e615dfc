#include "models/bunch/berry/berry.hpp"

#include <doctest/doctest.h>

#include "foundation/fingerprint.hpp"
#include "mesh/surface.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::test;

TEST_CASE("the berry is a closed surface, sound at every number of segments") {
  for (const std::uint32_t segments : {6u, 7u, 12u, 24u, 33u, 64u, 128u}) {
    CAPTURE(segments);
    const Mesh berry = make_berry({segments});
    check_sound(berry);
    const Surface surface = surface_of(berry, 0, berry.indices.size());
    CHECK(surface.open_edges == 0);
    CHECK(share_turned(berry) == 0);
    CHECK(berry.positions.size() / 3 == (segments + 1) * (segments * 3 / 4) + 2 * segments);
    CHECK(berry.indices.size() / 3 == 2 * segments * (segments * 3 / 4));
  }
}

TEST_CASE("it lies within the unit sphere and nearly fills it") {
  const Mesh berry = make_berry({});
  double furthest = 0, nearest = 2;
  for (std::uint32_t i = 0; i < berry.positions.size() / 3; ++i) {
    furthest = std::max(furthest, glm::length(position_of(berry, i)));
    nearest = std::min(nearest, glm::length(position_of(berry, i)));
  }
  CHECK(furthest <= 1 + 1e-7);
  CHECK(furthest > 1 - 1e-6);
  CHECK(nearest > 0.96);
  const double sphere = 4.18879020478639;
  CHECK(surface_of(berry, 0, berry.indices.size()).volume == doctest::Approx(sphere * 0.975).epsilon(0.01));
  const Mesh fine = make_berry({128});
  CHECK(surface_of(fine, 0, fine.indices.size()).volume == doctest::Approx(sphere * 0.9955).epsilon(0.001));
}

TEST_CASE("the tip has a dimple with the rest of the style in it, and the seat is flattened") {
  const Mesh berry = make_berry({128});
  double tip = 0, seat = 0, rim = 0;
  for (std::uint32_t i = 0; i < berry.positions.size() / 3; ++i) {
    const glm::dvec3 p = position_of(berry, i);
    const double v = berry.uvs[2 * i + 1];
    if (v == 1) tip = p.y;
    if (v == 0) seat = p.y;
    if (v > 0.955 && v < 0.965) rim = glm::length(p);
  }
  CHECK(tip == doctest::Approx(0.986));
  CHECK(seat == doctest::Approx(-0.978));
  CHECK(rim < 0.972);
  CHECK(rim < tip);
}

TEST_CASE("u goes round, v from the seat to the tip, both within 0 … 1") {
  const Mesh berry = make_berry({});
  bool scar_seen = false;
  for (std::uint32_t i = 0; i < berry.positions.size() / 3; ++i) {
    const double u = berry.uvs[2 * i], v = berry.uvs[2 * i + 1];
    REQUIRE(u >= 0);
    REQUIRE(u <= 1);
    REQUIRE(v >= 0);
    REQUIRE(v <= 1);
    const glm::dvec3 p = glm::normalize(position_of(berry, i));
    CHECK(std::acos(std::clamp(-p.y, -1.0, 1.0)) / 3.14159265358979 == doctest::Approx(v).epsilon(1e-3));
    if (v > berry_scar_v && v < 1) scar_seen = true;
  }
  CHECK(scar_seen);
}

TEST_CASE("segments are clamped to 6 … 128, and the default of 24 has few enough triangles for a bunch") {
  CHECK(make_berry({0}).positions == make_berry({6}).positions);
  CHECK(make_berry({100000}).positions == make_berry({128}).positions);
  CHECK(make_berry({}).positions.size() / 3 == 498);
  CHECK(make_berry({}).indices.size() / 3 == 864);
}

TEST_CASE("the default berry's numbers are the same on all toolchains") {
  const Mesh berry = make_berry({});
  Fingerprint fingerprint;
  fingerprint.add(std::span<const float>(berry.positions));
  fingerprint.add(std::span<const float>(berry.normals));
  fingerprint.add(std::span<const float>(berry.uvs));
  fingerprint.add(std::span<const std::uint32_t>(berry.indices));
  CHECK(fingerprint.value() == 0xcb1f24439e531195u);
}
