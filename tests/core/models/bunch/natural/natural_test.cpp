// The natural procedure as a whole: what it promises for any profile.
#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "models/bunch/fruit/berry_meridian.hpp"
#include "models/bunch/measures/measures.generated.hpp"
#include "models/bunch/natural/ripening.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

// A profile that a person might draw: wide enough for berries.
Profile drawn_profile(std::uint64_t seed) {
  const auto pick = [seed](std::uint64_t k, std::int32_t low, std::int32_t high) {
    return static_cast<float>(random_integer(seed, hash_text("drawn"), k, low, high));
  };
  Profile profile{pick(0, 200, 560), {}};
  for (std::uint64_t i = 0; i < 4; ++i)
    profile.sides[i] = {pick(1 + i, 40, 220), std::min(pick(5 + i, 20, 260), 0.9f * profile.length)};
  return profile;
}

void check_whole(const Grown& bunch) {
  CHECK(bunch.natural);
  CHECK(bunch.traits.size() == bunch.berries.size());
  std::uint32_t lost = 0;
  for (const Thinned& one : bunch.thinned) lost += one.why != Why::not_set;
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
    Request request = natural_request(seed % 4 ? drawn_profile(seed) : random_profile(seed));
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

TEST_CASE("the same request gives the same bunch, whatever grew between; another seed another") {
  const Request request = natural_request(table3[1].profile());
  const std::uint64_t first = grown(request).fingerprint;
  Request other = request;
  other.seed = 2;
  CHECK(grown(other).fingerprint != first);
  CHECK(grown(request).fingerprint == first);
}

TEST_CASE("berries keep to the outline: coverage and spill over the grape shapes and drawn profiles") {
  double coverage = 0, spill = 0, least = 1, most = 0;
  int count = 0;
  for (int k = 0; k < 29; ++k) {
    const Profile profile =
        k < 9 ? table3[static_cast<std::size_t>(k)].profile() : drawn_profile(static_cast<std::uint64_t>(k));
    Request request = natural_request(profile);
    request.measures = true;
    const Grown bunch = grown(request);
    const double covered = bunch.measures[static_cast<std::size_t>(Measure::coverage)];
    const double spilt = bunch.measures[static_cast<std::size_t>(Measure::spill)];
    coverage += covered;
    spill += spilt;
    least = std::min(least, covered);
    most = std::max(most, spilt);
    ++count;
  }
  MESSAGE("coverage mean " << coverage / count << ", least " << least << "; spill mean " << spill / count << ", most "
                           << most);
  CHECK(coverage / count >= 0.92);
  CHECK(least >= 0.85);
  CHECK(spill / count <= 0.03);
  CHECK(most <= 0.06);
}

TEST_CASE("one pixel of the profile moves the mean berry by less than 0.5 mm") {
  double sum = 0, worst = 0;
  const int steps = 200;
  for (int step = 0; step < steps; ++step) {
    const auto seed = static_cast<std::uint64_t>(step);
    Profile profile = table3[static_cast<std::size_t>(random_integer(seed, 2, 0, 0, 8))].profile();
    profile.length += static_cast<float>(random_integer(seed, 3, 0, -20, 20));
    for (std::size_t i = 0; i < 4; ++i) {
      SidePoint& side = profile.sides[i];
      side.width = std::max(0.0f, side.width + static_cast<float>(random_integer(seed, 4, i, -30, 30)));
      side.drop = std::max(0.0f, side.drop + static_cast<float>(random_integer(seed, 7, i, -30, 30)));
    }
    const Grown before = grown(natural_request(profile));
    const std::int32_t which = random_integer(seed, 5, 0, 0, 8);
    const float by = random_unit(seed, 6, 0) < 0.5f ? -1.0f : 1.0f;
    float& moved = which == 0   ? profile.length
                   : which <= 4 ? profile.sides[static_cast<std::size_t>(which - 1)].width
                                : profile.sides[static_cast<std::size_t>(which - 5)].drop;
    moved = std::max(0.0f, moved + by);
    const Grown after = grown(natural_request(profile));
    std::map<std::uint32_t, glm::vec3> places;
    for (const Berry& berry : before.berries) places[berry.id] = berry.centre;
    double way = 0;
    int common = 0;
    for (const Berry& berry : after.berries)
      if (const auto at = places.find(berry.id); at != places.end()) {
        way += glm::length(at->second - berry.centre) * 1000.0;
        ++common;
      }
    REQUIRE(common > 0);
    sum += way / common;
    worst = std::max(worst, way / common);
  }
  MESSAGE("mean of " << steps << " steps " << sum / steps << " mm, worst " << worst << " mm");
  CHECK(worst < 0.5);
}

TEST_CASE("a count asked for is given within 3 %, or a note says why not") {
  int noted = 0;
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    CAPTURE(seed);
    Request request = natural_request(drawn_profile(seed));
    const float asked = static_cast<float>(random_integer(seed, 9, 0, 20, 320));
    set(request, Parameter::count, asked);
    const Grown bunch = grown(request);
    const bool near = std::abs(static_cast<float>(bunch.counts.berries) - asked) <= 0.03f * asked + 0.5f;
    if (!near) {
      REQUIRE(bunch.notes.size() == 1);
      CHECK(bunch.notes[0].find("found room") != std::string::npos);
      ++noted;
    }
  }
  MESSAGE(noted << " of 16 counts found no room");
  CHECK(noted <= 3);
}

TEST_CASE("a profile that would hold more berries than there may be grows the most, and says so") {
  for (const float count : {0.0f, 3000.0f}) {
    Request request = natural_request(random_profile(3));
    set(request, Parameter::size, 3);
    set(request, Parameter::unit, 2);
    set(request, Parameter::density, 9);
    set(request, Parameter::count, count);
    const Grown bunch = grown(request);
    CHECK(bunch.counts.berries <= 3000);
    CHECK(bunch.counts.berries > 1500);
    if (count == 0) {
      REQUIRE(bunch.notes.size() == 1);
      CHECK(bunch.notes[0].find("3000 berries at the most") != std::string::npos);
    }
  }
}

TEST_CASE("density sets how full a bunch is, size how large its berries are, spread how unlike") {
  const auto bunch = [](Parameter key, float value) {
    Request request = natural_request(table3[2].profile());
    set(request, key, value);
    return grown(request);
  };
  std::uint32_t before = 0;
  for (const float density : {1.0f, 3.0f, 5.0f, 7.0f, 9.0f}) {
    const std::uint32_t berries = bunch(Parameter::density, density).counts.berries;
    CHECK(berries > before);
    before = berries;
  }
  const auto widths = [](const Grown& one) {
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

TEST_CASE("a berry taken off by hand is gone, says so, and leaves the others where they were") {
  Request request = natural_request(table3[0].profile());
  const Grown whole = grown(request);
  const std::uint32_t id = whole.berries[whole.berries.size() / 2].id;
  request.thinned = {id};
  const Grown less = grown(request);
  CHECK(less.counts.berries == whole.counts.berries - 1);
  CHECK(std::count_if(less.thinned.begin(), less.thinned.end(),
                      [&](const Thinned& one) { return one.id == id && one.why == Why::by_hand; }) == 1);
  std::map<std::uint32_t, glm::vec3> places;
  for (const Berry& berry : whole.berries) places[berry.id] = berry.centre;
  double way = 0;
  for (const Berry& berry : less.berries) {
    REQUIRE(places.count(berry.id) == 1);
    way += glm::length(places[berry.id] - berry.centre) * 1000.0;
  }
  CHECK(way / less.counts.berries < 0.3);
}

TEST_CASE("ages pass into one another: flowers, then berries that grow") {
  const auto at = [](float age) {
    Request request = natural_request(table3[0].profile());
    set(request, Parameter::age, age);
    return grown(request);
  };
  CHECK(at(3).counts.berries > 1.2 * at(30).counts.berries);
  float before = 0;
  for (const float age : {12.0f, 25.0f, 45.0f, 70.0f, 100.0f}) {
    const Grown bunch = at(age);
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

TEST_CASE("sun colours the lit side first; little vigour leaves the far berries small") {
  Request request = natural_request(table3[2].profile());
  set(request, Parameter::age, 75);
  set(request, Parameter::sun, 90);
  set(request, Parameter::sunlight, 1);
  const Grown lit = grown(request);
  double right = 0, left = 0;
  int rights = 0, lefts = 0;
  for (std::size_t i = 0; i < lit.berries.size(); ++i) {
    (lit.berries[i].centre.x > 0 ? right : left) += lit.traits[i].turned;
    ++(lit.berries[i].centre.x > 0 ? rights : lefts);
  }
  CHECK(right / rights > left / lefts + 0.02);

  Request weak = natural_request(table3[2].profile());
  set(weak, Parameter::vigour, 0);
  set(weak, Parameter::spread, 2);
  const Grown poor = grown(weak);
  double near = 0, far = 0;
  int nears = 0, fars = 0;
  for (std::size_t i = 0; i < poor.berries.size(); ++i) {
    const bool upper = poor.berries[i].centre.y > -0.1f;
    (upper ? near : far) += poor.traits[i].width;
    ++(upper ? nears : fars);
  }
  CHECK(near / nears > 1.03 * far / fars);
}

TEST_CASE("a person's own grammar grows naturally too") {
  Request request = natural_request(table3[1].profile());
  request.grammar = builtin_grammar(3);
  const Grown bunch = grown(request);
  check_whole(bunch);
  CHECK(bunch.counts.berries > 30);
  request.grammar = "axiom: F(10)";
  CHECK(grown(request).counts.berries == 0);
  request.grammar = "axiom: ?E(0,0)\n?E(a,b) : 1 --> F(1)";
  CHECK(!grow(request));
}

TEST_CASE("grammars that mean harm end in words or in a bunch, soon") {
  Request request = natural_request(table3[1].profile());
  set(request, Parameter::count, 3000);
  const auto reason = [&](const char* text) {
    request.grammar = text;
    const auto result = grow(request);
    return result ? Reason::none : result.error().reason;
  };
  CHECK(reason("axiom: F(10) S(1)") == Reason::none);  // no stem but the pedicel
  CHECK(reason("axiom: S(1) F(1)") == Reason::none);
  CHECK(reason("axiom: F(10) [F(10) S(1)] [+(90) F(100000000000000000000000) S(1)]") == Reason::limit);
  CHECK(reason("axiom: F(50) [A(16)]\nA(n) : n>0 --> [A(n-1)] [A(n-1)]\nA(n) : n=0 --> [F(1) S(1)]") == Reason::limit);
  CHECK(reason("axiom: F(50) [A(11)]\nA(n) : n>0 --> [A(n-1)] [A(n-1)]\nA(n) : n=0 --> [F(1) S(0.00000001)]") ==
        Reason::none);
}

TEST_CASE("a count beyond what the outline holds leaves what has room, not an impossible heap") {
  for (const float count : {600.0f, 3000.0f}) {
    Request request = natural_request(table3[2].profile());
    set(request, Parameter::count, count);
    request.measures = true;
    const Grown bunch = grown(request);
    CHECK(bunch.notes.size() == 1);
    CHECK(bunch.measures[static_cast<std::size_t>(Measure::fill_ratio)] < 0.8f);
  }
}

TEST_CASE("pressed berries hold their volume within 3 %, however dense the bunch") {
  for (const float density : {5.0f, 7.0f, 9.0f}) {
    Request request = natural_request(table3[0].profile());
    set(request, Parameter::density, density);
    request.meshes = true;
    const Grown bunch = grown(request);
    const BerrySurfaces& surfaces = *bunch.surfaces;
    const std::size_t vertices = surfaces.uvs.size() / 2;
    double worst = 0;
    for (std::size_t i = 0; i < bunch.berries.size(); ++i) {
      const auto at = [&](std::size_t k) {
        const float* const p = surfaces.positions.data() + 3 * (i * vertices + surfaces.indices[k]);
        return glm::dvec3(p[0], p[1], p[2]) - glm::dvec3(bunch.berries[i].centre);
      };
      double volume = 0;
      for (std::size_t k = 0; k < surfaces.indices.size(); k += 3)
        volume += glm::dot(at(k), glm::cross(at(k + 1), at(k + 2))) / 6;
      const double free = form_volume(bunch.form, bunch.traits[i].width / 2, bunch.traits[i].length / 2);
      worst = std::max(worst, std::abs(volume / free - 1));
    }
    MESSAGE("density " << density << ", " << bunch.berries.size() << " berries: volume off by " << 100 * worst
                       << " % at the most");
    CHECK(worst < 0.03);
  }
}

TEST_CASE("an age is a function of the request alone: what was grown between changes nothing of it") {
  Request request = natural_request(table3[0].profile());
  set(request, Parameter::age, 42);
  request.meshes = request.mesh_fingerprint = true;
  const Grown first = grown(request);
  for (const float age : {0.0f, 125.0f}) {
    Request other = request;
    set(other, Parameter::age, age);
    CHECK(grown(other).fingerprint != first.fingerprint);
  }
  const Grown again = grown(request);
  CHECK(again.fingerprint == first.fingerprint);
  CHECK(again.mesh_fingerprint == first.mesh_fingerprint);
  // Widths at 42 lie on the double sigmoid, whatever was grown before.
  const Grown ripe = grown(natural_request(table3[0].profile()));
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

TEST_CASE("dried berries are furrowed in the mesh as far as their traits say") {
  Request request = natural_request(table3[0].profile());
  set(request, Parameter::age, 125);
  request.meshes = true;
  request.berry_segments = 24;
  const Grown bunch = grown(request);
  std::vector<BerryBody> bodies;
  for (std::size_t i = 0; i < bunch.berries.size(); ++i) {
    const Traits& traits = bunch.traits[i];
    CHECK(traits.shrivel > 0.3f);
    bodies.push_back({bunch.berries[i].centre * 1000.0f, bunch.berries[i].direction, traits.width * 500,
                      traits.length * 500, traits.shrivel, bunch.berries[i].id});
  }
  // The same bodies pressed apart from the growth.
  BerryOptions options;
  options.segments = request.berry_segments;
  const BerrySurfaces surfaces = press_berries(bodies, bunch.form, options);
  REQUIRE(surfaces.positions.size() == bunch.surfaces->positions.size());
  float worst = 0;
  for (std::size_t i = 0; i < surfaces.positions.size(); ++i)
    worst = std::max(worst, std::abs(surfaces.positions[i] - 1000 * bunch.surfaces->positions[i]));
  CHECK(worst < 0.05f);  // millimetres; furrows are deeper by far
}

TEST_CASE("what is not there says where it hung: on the skeleton, in metres") {
  Request request = natural_request(table3[2].profile());
  set(request, Parameter::count, 600);  // more than there is room for
  const Grown bunch = grown(request);
  std::set<Why> reasons;
  for (const Thinned& one : bunch.thinned) {
    reasons.insert(one.why);
    float nearest = 1;
    for (const Internode& internode : bunch.internodes)
      nearest = std::min({nearest, glm::length(internode.end - one.place), glm::length(internode.start - one.place)});
    CHECK(nearest < 0.02f);  // branches bend by less
    if (one.why == Why::no_room) CHECK(nearest < 1e-6f);
  }
  CHECK(reasons == std::set<Why>{Why::not_set, Why::no_room});
}
