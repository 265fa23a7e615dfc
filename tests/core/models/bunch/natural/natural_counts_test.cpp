// The number of berries of a natural bunch, and the outcome of the others.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "foundation/english.hpp"
#include "models/bunch/measures/measures.generated.hpp"
#include "models/bunch/natural/drawn_profile.hpp"
#include "models/bunch/natural/natural_plan.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

TEST_CASE("a requested count is met within 3 %, or a note has the reason") {
  int noted = 0;
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    CAPTURE(seed);
    BunchRequest request = natural_request(drawn_profile(seed));
    const float requested = static_cast<float>(random_integer(seed, 9, 0, 20, 320));
    set(request, Parameter::count, requested);
    const GrownBunch bunch = grown(request);
    const bool near = std::abs(static_cast<float>(bunch.counts.berries) - requested) <= 0.03f * requested + 0.5f;
    if (!near) {
      REQUIRE(bunch.notes.size() == 1);
      CHECK(english(bunch.notes[0]).find("requested berries fit") != std::string::npos);
      // Only for counts that crowd the outline.
      BunchRequest densest = natural_request(drawn_profile(seed));
      set(densest, Parameter::density, 9);
      std::vector<std::string> notes;
      const Values values(densest.parameters, notes);
      const float most = make_natural_plan(values.profile(), values, 3000).berries;
      MESSAGE(seed << ": " << bunch.counts.berries << " of " << requested << ", where the densest are " << most);
      CHECK(requested > 0.8f * most);
      ++noted;
    }
  }
  MESSAGE(noted << " of 16 counts found no room");
  CHECK(noted <= 4);
}

TEST_CASE("a profile that would exceed the limit of berries grows as many as allowed, with a note") {
  for (const float count : {0.0f, 3000.0f}) {
    BunchRequest request = natural_request(random_profile(3));
    set(request, Parameter::size, 3);
    set(request, Parameter::unit, 2);
    set(request, Parameter::density, 9);
    set(request, Parameter::count, count);
    const GrownBunch bunch = grown(request);
    CHECK(bunch.counts.berries <= 3000);
    CHECK(bunch.counts.berries > 1500);
    if (count == 0) {
      REQUIRE(bunch.notes.size() == 1);
      CHECK(english(bunch.notes[0]).find("the limit of 3000 berries") != std::string::npos);
    }
  }
}

TEST_CASE("a count beyond the outline's room grows the berries that have room") {
  for (const float count : {600.0f, 3000.0f}) {
    BunchRequest request = natural_request(table3[2].profile());
    set(request, Parameter::count, count);
    request.measures = true;
    const GrownBunch bunch = grown(request);
    CHECK(bunch.notes.size() == 1);
    CHECK(bunch.measures[static_cast<std::size_t>(Measure::fill_ratio)] < 0.8f);
  }
}

TEST_CASE("density sets how full a bunch is, size how large its berries are, spread how much they vary") {
  const auto bunch = [](Parameter key, float value) {
    BunchRequest request = natural_request(table3[2].profile());
    set(request, key, value);
    return grown(request);
  };
  std::uint32_t before = 0;
  for (const float density : {1.0f, 3.0f, 5.0f, 7.0f, 9.0f}) {
    const std::uint32_t berries = bunch(Parameter::density, density).counts.berries;
    CHECK(berries > before);
    before = berries;
  }
  const auto widths = [](const GrownBunch& one) {
    double sum = 0, square = 0;
    for (const Traits& traits : one.traits) {
      sum += traits.width;
      square += double(traits.width) * traits.width;
    }
    const auto n = static_cast<double>(one.traits.size());
    return std::pair{1000 * sum / n, std::sqrt(square / n - sum / n * (sum / n)) / (sum / n)};
  };
  CHECK(widths(bunch(Parameter::size, 14)).first == doctest::Approx(14).epsilon(0.04));
  CHECK(widths(bunch(Parameter::size, 22)).first == doctest::Approx(22).epsilon(0.04));
  CHECK(widths(bunch(Parameter::spread, 2)).second < widths(bunch(Parameter::spread, 10)).second);
  CHECK(widths(bunch(Parameter::spread, 10)).second < widths(bunch(Parameter::spread, 25)).second);
}

TEST_CASE("a berry removed by hand is gone, with its reason, and the others stay in place") {
  BunchRequest request = natural_request(table3[0].profile());
  const GrownBunch whole = grown(request);
  const std::uint32_t id = whole.berries[whole.berries.size() / 2].id;
  request.thinned = {id};
  const GrownBunch less = grown(request);
  CHECK(less.counts.berries == whole.counts.berries - 1);
  CHECK(std::count_if(less.thinned.begin(), less.thinned.end(),
                      [&](const Thinned& one) { return one.id == id && one.why == RemovalReason::by_hand; }) == 1);
  std::map<std::uint32_t, glm::vec3> places;
  for (const Berry& berry : whole.berries) places[berry.id] = berry.centre;
  double way = 0;
  for (const Berry& berry : less.berries) {
    REQUIRE(places.count(berry.id) == 1);
    way += glm::length(places[berry.id] - berry.centre) * 1000.0;
  }
  CHECK(way / less.counts.berries < 0.3);
}

TEST_CASE("missing berries have their place on the skeleton, in metres") {
  BunchRequest request = natural_request(table3[2].profile());
  set(request, Parameter::count, 600);  // more than there is room for
  const GrownBunch bunch = grown(request);
  std::set<RemovalReason> reasons;
  for (const Thinned& one : bunch.thinned) {
    reasons.insert(one.why);
    float nearest = 1;
    for (const Internode& internode : bunch.internodes)
      nearest = std::min({nearest, glm::length(internode.end - one.place), glm::length(internode.start - one.place)});
    CHECK(nearest < 0.02f);  // branches bend by less
    if (one.why == RemovalReason::no_room) CHECK(nearest < 1e-6f);
  }
  CHECK(reasons == std::set<RemovalReason>{RemovalReason::not_set, RemovalReason::no_room});
}
