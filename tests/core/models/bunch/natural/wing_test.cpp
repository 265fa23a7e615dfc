// A second bunch beside the first, on a stalk that bends.
#include "models/bunch/natural/wing.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "models/bunch/measures/measures.generated.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

const Profile profile = table3[0].profile();
const Envelope large(profile, 0.43f, 20), small(scaled(profile, 0.4f), 0.43f, 20);

BunchRequest winged(float wing, float side = 1, float age = 100) {
  BunchRequest request = natural_request(profile);
  set(request, Parameter::wing, wing);
  set(request, Parameter::wing_side, side);
  set(request, Parameter::age, age);
  set(request, Parameter::variability, 0);
  request.measures = true;
  return request;
}

// Of the second bunch: the middle of its berries, metres.
glm::vec3 middle_of_wing(const GrownBunch& grown) {
  std::vector<std::uint8_t> second(grown.internodes.size(), 0);
  for (std::size_t i = 0; i < grown.internodes.size(); ++i) {
    const std::int32_t parent = grown.internodes[i].parent;
    second[i] =
        static_cast<std::int32_t>(i) == grown.second_root || (parent >= 0 && second[static_cast<std::size_t>(parent)]);
  }
  glm::vec3 sum(0);
  float count = 0;
  for (const Berry& berry : grown.berries)
    if (second[static_cast<std::size_t>(berry.parent)]) {
      sum += berry.centre;
      count += 1;
    }
  REQUIRE(count > 0);
  return sum / count;
}

}  // namespace

TEST_CASE("turning a stance upright and back is the identity, and its own down becomes down") {
  for (std::size_t side = 0; side < 4; ++side) {
    const Stance stance{35, side, {3, 5, -2}};
    const UprightTransform upright(stance);
    const glm::vec3 v(0.3f, -0.7f, 0.2f);
    CHECK(glm::length(upright.way_back(upright.way(v)) - v) < 1e-6f);
    CHECK(glm::length(upright.place(stance.foot)) == 0);
    const glm::vec3 down = upright.way_back({0, -1, 0});
    CHECK(down.y == doctest::Approx(-0.819f).epsilon(0.001));
    const float out[] = {down.x, -down.x, down.z, -down.z};
    CHECK(out[side] == doctest::Approx(0.574f).epsilon(0.001));
  }
}

TEST_CASE("a wing's stalk leaves at its angle and bends down under its load, the more the heavier") {
  float before = 81;
  for (const float load : {0.0f, 5.0f, 20.0f, 100.0f}) {
    const WingStalk stalk{10, 80, 1, load};
    const Stance stance = wing_stance(stalk, large, small);
    CHECK(stance.lean < before);
    before = stance.lean;
    const std::vector<Internode> pieces = wing_stalk(stalk, stance, 3, 2);
    REQUIRE(pieces.size() >= 4);
    CHECK(pieces[0].parent == -1);
    CHECK(pieces[0].start == glm::vec3(0, 10, 0));
    CHECK(pieces.back().end == stance.foot);
    CHECK(pieces[0].radius == 1.5f);
    CHECK(pieces.back().radius_end == doctest::Approx(1));
    const auto angle = [](const Internode& piece) {
      const glm::vec3 way = glm::normalize(piece.end - piece.start);
      return std::atan2(-way.x, -way.y) * 180 / 3.14159265f;
    };
    CHECK(angle(pieces[0]) == doctest::Approx(80 - (80 - stance.lean) / 12).epsilon(0.03));
    CHECK(angle(pieces.back()) == doctest::Approx(stance.lean + (80 - stance.lean) / 12).epsilon(0.05));
    for (std::size_t k = 1; k < pieces.size(); ++k) CHECK(angle(pieces[k]) <= angle(pieces[k - 1]) + 0.01f);
    // Beside the bunch and not in it.
    CHECK(-stance.foot.x > 0.65f * large.half_width(1, profile.sides[1].drop * 0.43f));
  }
}

TEST_CASE("a wing of any shape hangs on its side, and OIV 209 counts it") {
  const auto wings = static_cast<std::size_t>(Measure::wings), coverage = static_cast<std::size_t>(Measure::coverage),
             spill = static_cast<std::size_t>(Measure::spill);
  const float without = grown(winged(0)).measures[wings];
  for (int side = 0; side < 4; ++side) {
    CAPTURE(side);
    const GrownBunch one = grown(winged(0.4f, static_cast<float>(side)));
    const glm::vec3 middle = middle_of_wing(one);
    const float out[] = {middle.x, -middle.x, middle.z, -middle.z};
    CHECK(out[side] > 0.02f);
    CHECK(std::abs(side < 2 ? middle.z : middle.x) < 0.01f);
    CHECK(one.measures[wings] == without + 1);
    // Its outline hangs at the same place.
    CHECK(one.measures[coverage] > 0.85f);
    CHECK(one.measures[spill] < 0.04f);
  }
}

TEST_CASE(
    "a wing's stalk is its own: it leaves the peduncle above p1, thinner than the rachis, and comes down as it "
    "ripens") {
  const GrownBunch ripe = grown(winged(0.4f));
  REQUIRE(ripe.second_root > 0);
  const Internode& stalk = ripe.internodes[static_cast<std::size_t>(ripe.second_root)];
  CHECK(stalk.start.y > 0.005f);
  CHECK(ripe.internodes[static_cast<std::size_t>(stalk.parent)].end.y == doctest::Approx(stalk.start.y).epsilon(0.05));
  const auto girth_of = [&](std::int32_t root) { return ripe.internodes[static_cast<std::size_t>(root)].radius; };
  CHECK(girth_of(ripe.second_root + 6) < 0.8f * stalk.radius);
  CHECK(middle_of_wing(grown(winged(0.4f, 1, 30))).y > middle_of_wing(ripe).y + 0.001f);
}

TEST_CASE("a wing's berries are the same at every age, except those lost and few that find room") {
  const auto ids_at = [](float age) {
    BunchRequest request = winged(0.4f, 1, age);
    set(request, Parameter::variability, 1);
    std::set<std::uint32_t> all;
    const GrownBunch one = grown(request);
    for (std::size_t i = 0; i < one.berries.size(); ++i)
      if (one.traits[i].set == 1) all.insert(one.berries[i].id);
    return all;
  };
  std::set<std::uint32_t> before = ids_at(40);
  for (const float age : {60.0f, 80.0f, 100.0f}) {
    CAPTURE(age);
    const std::set<std::uint32_t> now = ids_at(age);
    CHECK(now.size() > 0.9f * static_cast<float>(before.size()));
    const auto known = std::count_if(now.begin(), now.end(), [&](std::uint32_t id) { return before.count(id) > 0; });
    CHECK(static_cast<float>(known) >= 0.97f * static_cast<float>(now.size()));
    before = now;
  }
}

TEST_CASE("a stalk bends under the requested count of berries, independent of the density") {
  const auto stalk_end = [](float count, float density) {
    BunchRequest request = winged(0.4f);
    set(request, Parameter::count, count);
    set(request, Parameter::density, density);
    const GrownBunch one = grown(request);
    return one.internodes[static_cast<std::size_t>(one.second_root) + 5].end;
  };
  const glm::vec3 few = stalk_end(30, 5), many = stalk_end(150, 5);
  CHECK(few.y > many.y + 0.003f);
  CHECK(glm::length(stalk_end(30, 9) - few) < 0.001f);
}

TEST_CASE("a pixel of the profile moves a wing by little") {
  BunchRequest request = winged(0.4f);
  const glm::vec3 before = middle_of_wing(grown(request));
  for (const Parameter key : {Parameter::l, Parameter::p4w, Parameter::p4r}) {
    BunchRequest moved = request;
    set(moved, key, request.parameters[static_cast<std::size_t>(key)] + 1);
    CHECK(glm::length(middle_of_wing(grown(moved)) - before) < 0.002f);
  }
}
