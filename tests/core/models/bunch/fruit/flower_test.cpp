#include "models/bunch/fruit/flower.hpp"

#include <doctest/doctest.h>

#include "geometry/surface.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::test;

TEST_CASE(
    "the open flower is sixteen closed pieces facing outwards: a style, "
    "five filaments, ten lobes") {
  const Mesh flower = make_flower();
  check_sound(flower);
  CHECK(share_turned(flower) == 0);
  CHECK(flower.indices.size() / 3 <= 600);
  std::vector<std::size_t> first = {0};
  std::uint32_t furthest = 0;
  for (std::size_t t = 0; t < flower.indices.size(); t += 3) {
    const std::uint32_t* corner = &flower.indices[t];
    if (t > 0 && std::min({corner[0], corner[1], corner[2]}) > furthest) first.push_back(t);
    furthest = std::max({furthest, corner[0], corner[1], corner[2]});
  }
  first.push_back(flower.indices.size());
  REQUIRE(first.size() - 1 == 16);
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    const Surface piece = surface_of(flower, first[i], first[i + 1] - first[i]);
    CHECK(piece.open_edges == 0);
    CHECK(piece.volume > 0);
  }
}

TEST_CASE("it stands round the ovary and opens towards +Y") {
  const Mesh flower = make_flower();
  double low = 9, high = -9, wide = 0;
  double anthers_low = 9;
  for (std::uint32_t i = 0; i < flower.positions.size() / 3; ++i) {
    const glm::dvec3 p = position_of(flower, i);
    low = std::min(low, p.y);
    high = std::max(high, p.y);
    wide = std::max(wide, std::hypot(p.x, p.z));
    const double v = flower.uvs[2 * i + 1];
    CHECK(v >= 0);
    CHECK(v <= 1);
    if (v > 0.5) anthers_low = std::min(anthers_low, p.y);
  }
  CHECK(low > -1);
  CHECK(high > 2);
  CHECK(high < 3);
  CHECK(wide > 1.5);
  CHECK(wide < 2.2);
  CHECK(anthers_low > 1);
  CHECK(make_flower().positions == flower.positions);
}
