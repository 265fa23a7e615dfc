#include "models/bunch/bunch_sky.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "models/bunch/berry/berry.hpp"
#include "models/bunch/bunch.hpp"
#include "models/bunch/foliage/flat_leaf.hpp"
#include "models/bunch/parameters.generated.hpp"
#include "models/bunch/stems.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

GrownBunch grown_with(std::initializer_list<std::pair<Parameter, float>> values) {
  bunch::BunchRequest request;
  request.parameters.assign(std::size(parameter_table), std::numeric_limits<float>::quiet_NaN());
  for (const auto& [key, value] : values) request.parameters[static_cast<std::size_t>(key)] = value;
  request.measures = false;
  request.sky = true;
  request.leaf = flat_leaf();
  auto grown = grow(request);
  REQUIRE(grown);
  return std::move(grown.value());
}

// Round berries of unit radius on pedicels of their own that come from above.
GrownBunch hung(const std::vector<glm::vec3>& centres) {
  GrownBunch grown;
  for (const glm::vec3& centre : centres) {
    const auto pedicel = static_cast<std::int32_t>(grown.internodes.size());
    grown.internodes.push_back({{-1, 0, centre + glm::vec3(0, 2, 0), centre + glm::vec3(0, 1, 0), 0.1f, 0.1f},
                                Kind::pedicel,
                                State::grown,
                                0});
    grown.berries.push_back({centre, 1, {0, -1, 0}, pedicel, 0});
    grown.traits.push_back({2, 2});
  }
  grown.stem = sweep_internodes(grown.internodes, {}, 1);
  grown.berry = make_berry({});
  add_sky(grown);
  return grown;
}

double mean(std::span<const std::uint8_t> bytes) {
  double sum = 0;
  for (const std::uint8_t byte : bytes) sum += byte;
  return sum / static_cast<double>(bytes.size());
}

}  // namespace

TEST_CASE("a lone berry sees all of the sky, its pedicel all but the part that the berry hides") {
  const GrownBunch lone = hung({{0, 0, 0}});
  REQUIRE(lone.sky);
  CHECK(std::all_of(lone.sky->berries.begin(), lone.sky->berries.end(), [](std::uint8_t byte) { return byte == 255; }));
  REQUIRE(lone.sky->stems.size() == lone.stem->segment.size());
  std::uint8_t darkest = 255, brightest = 0;
  for (const std::uint8_t byte : lone.sky->stems) {
    darkest = std::min(darkest, byte);
    brightest = std::max(brightest, byte);
  }
  CHECK(darkest < 200);
  CHECK(brightest > 240);
}

TEST_CASE("two berries that touch darken each other where they do, and nowhere else") {
  const GrownBunch pair = hung({{-1, 0, 0}, {1, 0, 0}});
  const std::vector<float>& normals = pair.berry->normals;
  const std::size_t each = normals.size() / 3;
  REQUIRE(pair.sky->berries.size() == 2 * each);
  for (std::size_t berry = 0; berry < 2; ++berry) {
    for (std::size_t v = 0; v < each; ++v) {
      // Both hang, so the shared mesh is turned half round about X: its +X stays.
      const float towards = berry == 0 ? normals[3 * v] : -normals[3 * v];
      const int byte = pair.sky->berries[each * berry + v];
      if (towards > 0.99f) CHECK(byte < 30);
      if (towards < -0.5f) CHECK(byte > 245);
    }
  }
}

TEST_CASE("a rotated bunch sees as much") {
  const std::vector<glm::vec3> places{{-1, 0, 0}, {1, 0, 0}, {0, 1.8f, 0.3f}, {0.2f, -1.7f, 0.4f}};
  std::vector<glm::vec3> turned;
  for (const glm::vec3& p : places) turned.push_back({p.z, p.y, -p.x});
  const GrownBunch one = hung(places), other = hung(turned);
  // Turned by a quarter, the shared berry's meridians fall on each other: find each vertex's place in the other.
  const std::vector<float>& normals = one.berry->normals;
  const std::size_t each = normals.size() / 3;
  std::size_t found = 0;
  for (std::size_t v = 0; v < each; ++v) {
    const glm::vec3 there(-normals[3 * v + 2], normals[3 * v + 1], normals[3 * v]);
    for (std::size_t w = 0; w < each; ++w) {
      if (glm::distance(there, glm::vec3(normals[3 * w], normals[3 * w + 1], normals[3 * w + 2])) > 1e-4f) continue;
      ++found;
      for (std::size_t i = 0; i < places.size(); ++i)
        CHECK(std::abs(one.sky->berries[each * i + v] - other.sky->berries[each * i + w]) <= 1);
    }
  }
  CHECK(found >= each);
}

TEST_CASE("a long berry hides as one: along its length, not only about its middle") {
  const auto beside_tip = [](float width, float length) {
    GrownBunch grown;
    grown.internodes.push_back({{-1, 0, {0, 9, 0}, {0, 8, 0}, 0.1f, 0.1f}, Kind::pedicel, State::grown, 0});
    grown.berries = {{{0, 0, 0}, 1, {0, -1, 0}, 0, 0}, {{1.2f, -3, 0}, 0.4f, {0, -1, 0}, 0, 0}};
    grown.traits = {{width, length}, {0.8f, 0.8f}};
    grown.stem = sweep_internodes(grown.internodes, {}, 1);
    grown.berry = make_berry({});
    add_sky(grown);
    const std::size_t each = grown.berry->normals.size() / 3;
    return mean(std::span(grown.sky->berries).subspan(each, each));
  };
  CHECK(beside_tip(1.5f, 6) < beside_tip(2, 2) - 6);
}

TEST_CASE("a grown bunch: a byte for every vertex, dark where berries are pressed, light on the outside") {
  const GrownBunch grown = grown_with({});
  REQUIRE(grown.sky);
  const std::vector<std::uint8_t>& bytes = grown.sky->berries;
  const std::vector<std::uint8_t>& pressed = grown.surfaces->pressed;
  REQUIRE(bytes.size() == pressed.size());
  CHECK(grown.sky->stems.size() == grown.stem->segment.size());
  CHECK(grown.sky->foliage.empty());
  double in_contact = 0, contacts = 0, outside = 0, outer = 0, deepest = 0;
  for (const Berry& berry : grown.berries) deepest = std::min<double>(deepest, berry.centre.y);
  for (std::size_t v = 0; v < bytes.size(); ++v) {
    if (pressed[v] == 255) {
      in_contact += bytes[v];
      ++contacts;
    }
    const float* p = &grown.surfaces->positions[3 * v];
    if (p[1] < deepest && grown.surfaces->normals[3 * v + 1] < -0.9f) {  // below the lowest berry's middle
      outside += bytes[v];
      ++outer;
    }
  }
  REQUIRE(contacts > 1000);
  REQUIRE(outer > 3);
  CHECK(in_contact / contacts < 25);
  CHECK(outside / outer > 220);
  CHECK(mean(grown.sky->stems) < 80);  // most are among berries
}

TEST_CASE("leaves and cane are seen from, and hide") {
  const GrownBunch bare = grown_with({});
  const GrownBunch leafy = grown_with({{Parameter::leaves, 3}, {Parameter::cane, 1}});
  REQUIRE(leafy.foliage);
  REQUIRE(leafy.sky->foliage.size() == leafy.foliage->mesh.positions.size() / 3);
  CHECK(mean(leafy.sky->foliage) > 100);
  CHECK(*std::min_element(leafy.sky->foliage.begin(), leafy.sky->foliage.end()) < 100);
  REQUIRE(leafy.sky->berries.size() == bare.sky->berries.size());
  CHECK(mean(leafy.sky->berries) < mean(bare.sky->berries) - 0.3);
  int brighter = 0;  // by the small error of two bands in the space behind a point
  for (std::size_t v = 0; v < bare.sky->berries.size(); ++v)
    brighter = std::max(brighter, leafy.sky->berries[v] - bare.sky->berries[v]);
  CHECK(brighter < 12);
}

TEST_CASE("the paper's bunch: a byte for every vertex of the shared berry at every place") {
  const GrownBunch grown = grown_with({{Parameter::procedure, 0}});
  REQUIRE(grown.berry);
  CHECK(grown.sky->berries.size() == grown.berry->positions.size() / 3 * grown.berries.size());
  CHECK(grown.sky->stems.size() == grown.stem->segment.size());
  CHECK(mean(grown.sky->berries) > 150);  // they lie loosely
  CHECK(mean(grown.sky->berries) < 240);
}

TEST_CASE("there is no sky column unless requested, nor without meshes") {
  bunch::BunchRequest request;
  request.measures = false;
  CHECK(!grow(request)->sky);
  request.sky = true;
  request.meshes = false;
  CHECK(!grow(request)->sky);
}
