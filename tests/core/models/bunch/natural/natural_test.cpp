// The natural procedure as a whole: its properties for any profile.
#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "models/bunch/natural/drawn_profile.hpp"
#include "models/bunch/natural/ripening.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

void check_whole(const GrownBunch& bunch) {
  CHECK(bunch.natural);
  CHECK(bunch.traits.size() == bunch.berries.size());
  std::uint32_t lost = 0;
  for (const Thinned& one : bunch.thinned) lost += one.why != RemovalReason::not_set;
  CHECK(bunch.counts.withered == lost);
  CHECK(bunch.counts.berries + bunch.counts.withered == bunch.counts.pedicels);
  std::set<std::int32_t> parents;
  for (std::size_t i = 0; i < bunch.internodes.size(); ++i) {
    const Internode& one = bunch.internodes[i];
    CHECK(one.parent < static_cast<std::int32_t>(i));
    if (one.parent >= 0) CHECK(one.start == bunch.internodes[static_cast<std::size_t>(one.parent)].end);
    CHECK(one.start == one.start);
    CHECK(one.end == one.end);
    CHECK(one.radius > 0);
  }
  for (std::size_t i = 0; i < bunch.berries.size(); ++i) {
    const Berry& berry = bunch.berries[i];
    CHECK(berry.centre == berry.centre);
    CHECK(berry.radius > 0);
    CHECK(glm::length(berry.direction) == doctest::Approx(1).epsilon(1e-4));
    REQUIRE(berry.parent >= 0);
    CHECK(bunch.internodes[static_cast<std::size_t>(berry.parent)].kind == Kind::pedicel);
    CHECK(parents.insert(berry.parent).second);
    const Traits& traits = bunch.traits[i];
    for (const float share : {traits.exposure, traits.turned, traits.opened, traits.set, traits.shrivel}) {
      CHECK(share >= 0);
      CHECK(share <= 1);
    }
  }
}

}  // namespace

TEST_CASE("a natural bunch is whole: any drawn profile, age, form and density") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    BunchRequest request = natural_request(seed % 4 ? drawn_profile(seed) : random_profile(seed));
    const auto pick = [&](Parameter key, std::int32_t low, std::int32_t high) {
      set(request, key, static_cast<float>(random_integer(seed, 77, static_cast<std::uint64_t>(key), low, high)));
    };
    pick(Parameter::age, 0, 125);
    pick(Parameter::density, 1, 9);
    pick(Parameter::size, 10, 30);
    pick(Parameter::elongation, 1, 3);
    if (seed % 5 == 0) set(request, Parameter::wing, 0.6f);
    check_whole(grown(request));
  }
}

TEST_CASE("the same request always gives the same bunch; another seed gives another") {
  const BunchRequest request = natural_request(table3[1].profile());
  const std::uint64_t first = grown(request).fingerprint;
  BunchRequest other = request;
  other.seed = 2;
  CHECK(grown(other).fingerprint != first);
  CHECK(grown(request).fingerprint == first);
}

TEST_CASE("ages pass into one another: flowers, then berries that grow") {
  const auto at = [](float age) {
    BunchRequest request = natural_request(table3[0].profile());
    set(request, Parameter::age, age);
    return grown(request);
  };
  CHECK(at(3).counts.berries > 1.2 * at(30).counts.berries);
  float before = 0;
  for (const float age : {12.0f, 25.0f, 45.0f, 70.0f, 100.0f}) {
    const GrownBunch bunch = at(age);
    float width = 0;
    for (const Traits& traits : bunch.traits) width = std::max(width, traits.width);
    CHECK(width > before);
    before = width;
  }
  const auto mean_move = [&](float a, float b) {
    std::map<std::uint32_t, glm::vec3> places;
    for (const Berry& berry : at(a).berries) places[berry.id] = berry.centre;
    double way = 0;
    int common = 0;
    for (const Berry& berry : at(b).berries)
      if (const auto found = places.find(berry.id); found != places.end()) {
        way += glm::length(found->second - berry.centre) * 1000.0;
        ++common;
      }
    return way / std::max(1, common);
  };
  for (float age = 14; age < 125; age += 18.5f) CHECK(mean_move(age, age + 0.5f) < 0.6);
}

TEST_CASE("growing other ages in between does not change the result of an age") {
  BunchRequest request = natural_request(table3[0].profile());
  set(request, Parameter::age, 42);
  request.meshes = request.mesh_fingerprint = true;
  const GrownBunch first = grown(request);
  for (const float age : {0.0f, 125.0f}) {
    BunchRequest other = request;
    set(other, Parameter::age, age);
    CHECK(grown(other).fingerprint != first.fingerprint);
  }
  const GrownBunch again = grown(request);
  CHECK(again.fingerprint == first.fingerprint);
  CHECK(again.mesh_fingerprint == first.mesh_fingerprint);
  // Widths at 42 lie on the double sigmoid, independent of earlier growth.
  const GrownBunch ripe = grown(natural_request(table3[0].profile()));
  std::map<std::uint32_t, float> widths;
  for (std::size_t i = 0; i < ripe.berries.size(); ++i) widths[ripe.berries[i].id] = ripe.traits[i].width;
  int common = 0;
  for (std::size_t i = 0; i < first.berries.size(); ++i)
    if (const auto found = widths.find(first.berries[i].id); found != widths.end()) {
      CHECK(first.traits[i].width / found->second == doctest::Approx(size_at(42)).epsilon(1e-4));
      ++common;
    }
  CHECK(common > 30);
}

TEST_CASE("the natural procedure accepts a grammar of the request") {
  BunchRequest request = natural_request(table3[1].profile());
  request.grammar = builtin_grammar(3);
  const GrownBunch bunch = grown(request);
  check_whole(bunch);
  CHECK(bunch.counts.berries > 30);
  request.grammar = "axiom: F(10)";
  CHECK(grown(request).counts.berries == 0);
  request.grammar = "axiom: ?E(0,0)\n?E(a,b) : 1 --> F(1)";
  CHECK(!grow(request));
}

TEST_CASE("hostile grammars end in an error or in a bunch, soon") {
  BunchRequest request = natural_request(table3[1].profile());
  set(request, Parameter::count, 3000);
  const auto reason = [&](const char* text) {
    request.grammar = text;
    const auto result = grow(request);
    return result ? Reason::none : result.error().reason;
  };
  CHECK(reason("axiom: F(10) S(1)") == Reason::none);  // no stem but the pedicel
  CHECK(reason("axiom: S(1) F(1)") == Reason::none);
  CHECK(reason("axiom: F(10) [F(10) S(1)] [+(90) F(100000000000000000000000) S(1)]") == Reason::evaluation);
  CHECK(reason("axiom: F(50) [A(16)]\nA(n) : n>0 --> [A(n-1)] [A(n-1)]\nA(n) : n=0 --> [F(1) S(1)]") == Reason::limit);
  CHECK(reason("axiom: F(50) [A(11)]\nA(n) : n>0 --> [A(n-1)] [A(n-1)]\nA(n) : n=0 --> [F(1) S(0.00000001)]") ==
        Reason::none);
}
