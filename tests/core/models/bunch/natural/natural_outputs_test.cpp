// What a natural bunch has besides its berries: flowers, cane and leaves, a second bunch.
#include <doctest/doctest.h>

#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

Request with_meshes(Parameter key, float value) {
  Request request = natural_request(table3[0].profile());
  set(request, key, value);
  request.meshes = true;
  return request;
}

}  // namespace

TEST_CASE("stamens come with flowers, and go when the last has set") {
  CHECK(grown(with_meshes(Parameter::age, 4)).flower.has_value());
  CHECK(!grown(with_meshes(Parameter::age, 60)).flower.has_value());
}

TEST_CASE("a cane comes when asked for, and as many leaves as are") {
  CHECK(!grown(with_meshes(Parameter::leaves, 0)).foliage.has_value());
  const auto parts = [](const Request& request) {
    const Grown bunch = grown(request);
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

TEST_CASE("a bunch and its wing bear a count between them, in the room of both") {
  Request request = natural_request(table3[2].profile());
  const std::uint32_t alone = grown(request).counts.berries;
  set(request, Parameter::wing, 0.5f);
  const auto asked = static_cast<float>(alone);
  set(request, Parameter::count, asked);
  const Grown both = grown(request);
  CHECK(static_cast<float>(both.counts.berries) > 0.95f * asked);
  CHECK(both.notes.empty());
}
