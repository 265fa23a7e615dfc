// The parts of a natural bunch besides its berries: flowers, cane and leaves, a second bunch.
#include <doctest/doctest.h>

#include "foundation/english.hpp"
#include "models/bunch/foliage/flat_leaf.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

BunchRequest with_meshes(Parameter key, float value) {
  BunchRequest request = natural_request(table3[0].profile());
  set(request, key, value);
  request.meshes = true;
  request.leaf = flat_leaf();
  return request;
}

}  // namespace

TEST_CASE("stamens come with flowers, and go when the last has set") {
  CHECK(grown(with_meshes(Parameter::age, 4)).flower.has_value());
  CHECK(!grown(with_meshes(Parameter::age, 60)).flower.has_value());
}

TEST_CASE("a bramble keeps its sepals, scaled to its ovary") {
  BunchRequest request = with_meshes(Parameter::fruit, static_cast<float>(Fruit::bramble));
  set(request, Parameter::size, 16);
  const GrownBunch ripe = grown(request);
  REQUIRE(ripe.flower.has_value());
  CHECK(ripe.flower->unit == doctest::Approx(0.016 * 0.075 / 2));
  CHECK(ripe.flower->pieces.back().kind == FlowerPiece::Kind::calyx);
}

TEST_CASE("in flower a bunch has a quarter of a ripe one's triangles") {
  const auto triangles = [](float age) {
    const GrownBunch bunch = grown(with_meshes(Parameter::age, age));
    return bunch.surfaces->indices.size() / 3;
  };
  CHECK(triangles(0) < triangles(100) / 4);
  // Segments follow the visible size: a small berry still has more than an ovary.
  CHECK(triangles(12) > triangles(0));
  CHECK(triangles(12) < triangles(100));
}

TEST_CASE("berries have no more seeds than requested, and seedless ones none") {
  const auto most = [](float seeds) {
    float highest = 0;
    for (const Traits& one : grown(with_meshes(Parameter::seeds, seeds)).traits) highest = std::max(highest, one.seeds);
    return highest;
  };
  CHECK(most(4) >= 3);
  CHECK(most(2) == 2);
  CHECK(most(0) == 0);
}

TEST_CASE("the requested cane and number of leaves grow") {
  CHECK(!grown(with_meshes(Parameter::leaves, 0)).foliage.has_value());
  const auto parts = [](const BunchRequest& request) {
    const GrownBunch bunch = grown(request);
    REQUIRE(bunch.foliage.has_value());
    std::size_t canes = 0, leaves = 0;
    for (const FoliagePart& part : bunch.foliage->parts) {
      canes += part.kind == FoliagePart::Kind::cane;
      leaves += part.kind == FoliagePart::Kind::leaf;
    }
    CHECK(canes == 1);
    return leaves;
  };
  CHECK(parts(with_meshes(Parameter::cane, 1)) == 0);
  CHECK(parts(with_meshes(Parameter::leaves, 3)) == 3);
}

TEST_CASE("without a leaf in the request the cane is bare, with a note") {
  BunchRequest request = with_meshes(Parameter::leaves, 3);
  CHECK(grown(request).notes.empty());
  request.leaf = {};
  const GrownBunch bare = grown(request);
  for (const FoliagePart& part : bare.foliage->parts) CHECK(part.kind != FoliagePart::Kind::leaf);
  REQUIRE(bare.notes.size() == 1);
  CHECK(english(bare.notes[0]).find("no leaves") != std::string::npos);
  // The columns are absent without meshes, and where they were not requested.
  request.meshes = false;
  CHECK(grown(request).notes.empty());
  BunchRequest cane = with_meshes(Parameter::cane, 1);
  cane.leaf = {};
  CHECK(grown(cane).notes.empty());
}

TEST_CASE("a bunch and its wing share a count by their room") {
  BunchRequest request = natural_request(table3[2].profile());
  const std::uint32_t alone = grown(request).counts.berries;
  set(request, Parameter::wing, 0.5f);
  const auto requested = static_cast<float>(alone);
  set(request, Parameter::count, requested);
  const GrownBunch both = grown(request);
  CHECK(static_cast<float>(both.counts.berries) > 0.95f * requested);
  CHECK(both.notes.empty());
}
