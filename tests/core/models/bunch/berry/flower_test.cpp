#include "models/bunch/berry/flower.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <vector>

#include "mesh/surface.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::test;
using Kind = FlowerPiece::Kind;

namespace {

constexpr Fruit fruits[] = {Fruit::grape, Fruit::currant, Fruit::bramble, Fruit::lychee, Fruit::longan, Fruit::duku};

std::vector<Kind> kinds_of(const FlowerMesh& flower) {
  std::vector<Kind> kinds;
  for (const FlowerPiece& piece : flower.pieces) kinds.push_back(piece.kind);
  return kinds;
}

FlowerPiece piece_of(const FlowerMesh& flower, Kind kind) {
  for (const FlowerPiece& piece : flower.pieces)
    if (piece.kind == kind) return piece;
  FAIL("no such piece");
  return {};
}

// The extent of a piece: lowest and highest point, and distance from the axis, in radii of the ovary.
struct Extent {
  double low = 99, high = -99, wide = 0;
};

Extent extent_of(const FlowerMesh& flower, Kind kind) {
  const FlowerPiece piece = piece_of(flower, kind);
  Extent extent;
  for (std::uint32_t i = piece.first_vertex; i < piece.first_vertex + piece.vertex_count; ++i) {
    const glm::dvec3 p = position_of(flower.mesh, i);
    extent.low = std::min(extent.low, p.y);
    extent.high = std::max(extent.high, p.y);
    extent.wide = std::max(extent.wide, std::hypot(p.x, p.z));
  }
  return extent;
}

}  // namespace

TEST_CASE("every piece of every flower is closed and faces outwards; its runs cover all of the mesh") {
  for (const Fruit fruit : fruits) {
    CAPTURE(static_cast<int>(fruit));
    const FlowerMesh flower = make_flower(fruit);
    check_sound(flower.mesh);
    std::uint32_t vertex = 0, index = 0;
    for (const FlowerPiece& piece : flower.pieces) {
      CHECK(piece.first_vertex == vertex);
      CHECK(piece.first_index == index);
      vertex += piece.vertex_count;
      index += piece.index_count;
      const Surface surface = surface_of(flower.mesh, piece.first_index, piece.index_count);
      CHECK(surface.open_edges == 0);
      CHECK(surface.volume > 0);
      for (std::uint32_t i = piece.first_index; i < index; ++i) {
        CHECK(flower.mesh.indices[i] >= piece.first_vertex);
        CHECK(flower.mesh.indices[i] < vertex);
      }
    }
    CHECK(vertex == flower.mesh.positions.size() / 3);
    CHECK(index == flower.mesh.indices.size());
    CHECK(make_flower(fruit).mesh.positions == flower.mesh.positions);
  }
}

TEST_CASE("grapes have a cap, brambles petals and a calyx, and all but brambles more pistils") {
  CHECK(kinds_of(make_flower(Fruit::grape)) == std::vector{Kind::stamens, Kind::cap, Kind::pistil});
  CHECK(kinds_of(make_flower(Fruit::lychee)) == std::vector{Kind::stamens, Kind::pistil});
  CHECK(kinds_of(make_flower(Fruit::bramble)) == std::vector{Kind::stamens, Kind::petals, Kind::calyx});
}

TEST_CASE("a piece of a flower has few triangles") {
  const FlowerMesh grape = make_flower(Fruit::grape);
  CHECK(piece_of(grape, Kind::stamens).index_count / 3 <= 140);
  CHECK(piece_of(grape, Kind::cap).index_count / 3 <= 40);
  CHECK(piece_of(grape, Kind::pistil).index_count / 3 <= 48);
}

TEST_CASE("stamens are round and above the ovary, a cap encloses it, a calyx is bent back") {
  const FlowerMesh grape = make_flower(Fruit::grape);
  const Extent stamens = extent_of(grape, Kind::stamens), cap = extent_of(grape, Kind::cap);
  CHECK(stamens.low > -1);
  CHECK(stamens.high > 2.5);
  CHECK(stamens.wide > 2);
  CHECK(stamens.wide < 4);
  CHECK(cap.wide > 1.1);
  CHECK(cap.high > 1.4);
  CHECK(extent_of(grape, Kind::pistil).low < -5);
  const FlowerMesh bramble = make_flower(Fruit::bramble);
  CHECK(extent_of(bramble, Kind::petals).wide > 10);
  CHECK(extent_of(bramble, Kind::calyx).low < -3);
  CHECK(extent_of(bramble, Kind::calyx).high < 0.5);
  CHECK(piece_of(make_flower(Fruit::lychee), Kind::stamens).index_count > piece_of(grape, Kind::stamens).index_count);
}

TEST_CASE("v distinguishes green parts, filaments, anthers and petals") {
  std::set<int> quarters;
  const FlowerMesh bramble = make_flower(Fruit::bramble);
  for (std::uint32_t i = 0; i < bramble.mesh.uvs.size() / 2; ++i) {
    const float v = bramble.mesh.uvs[2 * i + 1];
    REQUIRE(v >= 0);
    REQUIRE(v < 1);
    quarters.insert(static_cast<int>(4 * v));
  }
  CHECK(quarters == std::set<int>{0, 1, 2, 3});
}
