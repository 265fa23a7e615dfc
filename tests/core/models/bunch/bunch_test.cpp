#include "models/bunch/bunch.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "foundation/english.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

const Profile& shouldered() {
  static const Profile profile = table3[1].profile();
  return profile;
}

struct Expected {
  std::uint32_t end_structures = 0, racemes = 0, bunches = 0;
  void add(const Plan& plan) {
    ++bunches;
    ++end_structures;
    for (const std::int32_t n : plan.axes) {
      end_structures += static_cast<std::uint32_t>(n);
      racemes += n == 0;
    }
  }
  std::uint32_t pedicels() const { return 3 * end_structures + racemes; }
  std::uint32_t internodes() const { return 5 * end_structures - bunches + 2 * racemes; }
};

void check_counts(const GrownBunch& bunch) {
  Expected expected;
  expected.add(bunch.plan);
  if (bunch.second) expected.add(*bunch.second);
  CHECK(bunch.counts.berries + bunch.counts.withered == bunch.counts.pedicels);
  CHECK(bunch.counts.internodes == bunch.internodes.size());
  CHECK(bunch.counts.berries == bunch.berries.size());
  if (bunch.counts.cut > 0) return;
  CHECK(bunch.counts.end_structures == expected.end_structures);
  CHECK(bunch.counts.pedicels == expected.pedicels());
  CHECK(bunch.counts.internodes == expected.internodes());
}

double mean_berries(const BunchRequest& request, int seeds = 20) {
  double sum = 0;
  BunchRequest each = request;
  for (each.seed = 1; each.seed <= static_cast<std::uint32_t>(seeds); ++each.seed) sum += grown(each).counts.berries;
  return sum / seeds;
}

}  // namespace

TEST_CASE("L-system 1 with m = 3, n1 = 1, n2 = 2 gives 19 internodes and 12 berries") {
  for (const int system : {1, 3}) {
    BunchRequest request = as_printed(shouldered());
    request.grammar = builtin_grammar(system);
    request.m = 3;
    request.n = {1, 2};
    set_radius(request, 2, 3);
    const GrownBunch bunch = grown(request);
    CHECK(bunch.counts.internodes == 19);
    CHECK(bunch.counts.berries == 12);
    CHECK(bunch.plan.axes == std::vector<std::int32_t>{2, 1});
  }
}

TEST_CASE("L-system 2 separates the berries that overlap in L-system 1") {
  BunchRequest request = as_printed(shouldered());
  request.m = 5;
  request.n = {1, 2, 2, 3};
  request.grammar = builtin_grammar(1);
  CHECK(worst_overlap(grown(request)) > 0);
  request.grammar = builtin_grammar(2);
  const GrownBunch open = grown(request);
  CHECK(worst_overlap(open) == 0);
  CHECK(open.counts.berries > 5);
  CHECK(open.counts.withered > 0);
  for (const Berry& berry : open.berries) CHECK(berry.centre.z == doctest::Approx(0).epsilon(1e-6));
}

TEST_CASE("counts hold for every preset's profile") {
  for (const Table3Row& row : table3) {
    CAPTURE(row.name);
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
      check_counts(grown(request_for(row.profile(), seed)));
      check_counts(grown(as_printed(row.profile(), seed)));
    }
  }
}

TEST_CASE("counts hold and no two berries overlap for any profile and seed") {
  int uncut = 0;
  for (std::uint32_t seed = 1; seed <= 150; ++seed) {
    CAPTURE(seed);
    BunchRequest request = request_for(random_profile(seed), seed);
    const auto low = static_cast<float>(random_integer(seed, 1, 1, 2, 50));
    set_radius(request, low, low + 10);
    if (seed % 3 == 0) set(request, Parameter::wing, 0.6f);
    const GrownBunch bunch = grown(request);
    check_counts(bunch);
    CHECK(worst_overlap(bunch) == 0);
    uncut += bunch.counts.cut == 0;
  }
  CHECK(uncut > 30);
}

TEST_CASE("redcurrant is a raceme: 20 pedicels, 38 internodes") {
  const GrownBunch bunch = grown(as_printed(table3[9].profile()));
  CHECK(bunch.counts.cut == 0);
  CHECK(bunch.counts.pedicels == 20);
  CHECK(bunch.counts.internodes == 38);
}

TEST_CASE("the mean of berries falls strictly as they grow: the pattern of Table 2") {
  double last = 1e9;
  for (float radius = 10; radius <= 40; radius += 5) {
    BunchRequest request = as_printed(shouldered());
    set_radius(request, radius * 0.8f, radius * 1.2f);
    const double mean = mean_berries(request);
    MESSAGE("radius " << radius << ": " << mean << " berries");
    CHECK(mean < last);
    last = mean;
  }
}

TEST_CASE("the larger radius that the paper prints leaves its 20 to 30 berries, or somewhat more") {
  BunchRequest request = as_printed(shouldered());
  set_radius(request, 45, 55);
  const double mean = mean_berries(request);
  MESSAGE("radius 45 to 55: " << mean << " berries");
  CHECK(mean > 15);
  CHECK(mean < 45);
}

TEST_CASE("the same request gives the same fingerprint; another seed another") {
  const std::uint64_t first = grown(request_for(shouldered(), 7)).fingerprint;
  CHECK(grown(request_for(shouldered(), 8)).fingerprint != first);
  CHECK(grown(request_for(shouldered(), 7)).fingerprint == first);  // independent of growth in between
}

TEST_CASE("parents come first, axes are those of the plan, withered pedicels have no berries") {
  BunchRequest request = request_for(shouldered(), 3);
  set(request, Parameter::wing, 0.5f);
  const GrownBunch bunch = grown(request);
  const auto axes = static_cast<std::int32_t>(bunch.plan.axes.size() + bunch.second->axes.size());
  std::vector<int> berries(bunch.internodes.size(), 0);
  for (const Berry& berry : bunch.berries) ++berries[static_cast<std::size_t>(berry.parent)];
  for (std::size_t i = 0; i < bunch.internodes.size(); ++i) {
    const Internode& internode = bunch.internodes[i];
    CHECK(internode.parent < static_cast<std::int32_t>(i));
    CHECK(internode.axis < axes);
    if (internode.parent >= 0) {
      const Internode& parent = bunch.internodes[static_cast<std::size_t>(internode.parent)];
      CHECK(internode.start == parent.end);
      if (parent.axis >= 0) CHECK(internode.axis == parent.axis);
    }
    CHECK(berries[i] == (internode.kind == Kind::pedicel && internode.state == State::grown ? 1 : 0));
  }
}

TEST_CASE("every first-order axis has the internodes its count stands for") {
  BunchRequest request = as_printed(table3[1].profile());
  set_radius(request, 2, 3);
  const GrownBunch bunch = grown(request);
  REQUIRE(bunch.counts.cut == 0);
  std::vector<std::int32_t> found(bunch.plan.axes.size(), 0);
  std::int32_t rachis = 0;
  for (const Internode& internode : bunch.internodes)
    ++(internode.axis < 0 ? rachis : found[static_cast<std::size_t>(internode.axis)]);
  for (std::size_t s = 0; s < found.size(); ++s) CHECK(found[s] == 5 * bunch.plan.axes[s] - 1);
  CHECK(rachis == bunch.plan.m - 1 + 4);
}

TEST_CASE("sides point in the profile's directions") {
  const std::array<glm::vec3, 4> towards = {{{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}}};
  BunchRequest request = as_printed({290, {}});
  set_radius(request, 2, 2);
  for (std::int32_t side = 0; side < 4; ++side) {
    Profile profile{290, {}};
    profile.sides[static_cast<std::size_t>(side)] = {150, 400};
    set_profile(request, profile);
    glm::vec3 sum{0};
    const GrownBunch bunch = grown(request);
    for (const Internode& internode : bunch.internodes)
      if (internode.kind == Kind::axis) sum += internode.end;
    const glm::vec3 mean = glm::normalize(glm::vec3(sum.x, 0, sum.z));
    CHECK(glm::dot(mean, towards[static_cast<std::size_t>(side)]) > 0.9f);
  }
}

TEST_CASE("the second bunch is the first's profile times the wing") {
  BunchRequest request = request_for(shouldered());
  set(request, Parameter::wing, 0.5f);
  const GrownBunch bunch = grown(request);
  REQUIRE(bunch.second);
  CHECK(bunch.second->m == 7);  // nearest(377 · 0.5 / 29)
  CHECK(bunch.second->sides[0].n == 4);
  CHECK(!grown(request_for(shouldered())).second);
}

TEST_CASE("counts hold for two bunches of any of the grammars") {
  for (const int system : {1, 2, 3}) {
    CAPTURE(system);
    BunchRequest request = as_printed(shouldered());
    set(request, Parameter::wing, 0.6f);
    request.grammar = builtin_grammar(system);
    check_counts(grown(request));
  }
}

TEST_CASE("both bunches keep their rachis at every angle") {
  for (float angle = 25; angle <= 120; angle += 5) {
    CAPTURE(angle);
    BunchRequest request = request_for(shouldered());
    set(request, Parameter::wing, 0.8f);
    set(request, Parameter::wing_angle, angle);
    const GrownBunch bunch = grown(request);
    std::size_t rachis = 0;
    for (const Internode& internode : bunch.internodes) rachis += internode.kind == Kind::rachis;
    CHECK(rachis == static_cast<std::size_t>(bunch.plan.m + bunch.second->m - 2));
    CHECK(bunch.notes.empty());
  }
}

TEST_CASE("notes explain missing berries and ignored inputs") {
  BunchRequest crowded = request_for(shouldered());
  set(crowded, Parameter::wi, 40);
  set(crowded, Parameter::li, 10);
  REQUIRE(grown(crowded).notes.size() == 1);
  CHECK(english(grown(crowded).notes[0]).find("ends early") != std::string::npos);

  BunchRequest idle = request_for(shouldered());
  idle.grammar = builtin_grammar(1);
  set(idle, Parameter::li, 40);
  REQUIRE(grown(idle).notes.size() == 1);
  CHECK(english(grown(idle).notes[0]).find("no “#define l_i”") != std::string::npos);

  BunchRequest empty = request_for(shouldered());
  empty.grammar = "axiom: Z(3)\n";
  REQUIRE(grown(empty).notes.size() == 1);
  CHECK(english(grown(empty).notes[0]).find("draws nothing") != std::string::npos);
}

TEST_CASE("a second bunch finds room beside any grape of the paper") {
  for (std::size_t row = 0; row < 9; ++row) {
    CAPTURE(table3[row].name);
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
      BunchRequest request = request_for(table3[row].profile(), seed);
      set(request, Parameter::wing, 0.6f);
      const GrownBunch bunch = grown(request);
      std::size_t rachis = 0, berries = 0;
      for (const Internode& internode : bunch.internodes) rachis += internode.kind == Kind::rachis;
      for (const Berry& berry : bunch.berries)
        berries += bunch.internodes[static_cast<std::size_t>(berry.parent)].axis >= bunch.plan.m - 1;
      CHECK(rachis == static_cast<std::size_t>(bunch.plan.m + bunch.second->m - 2));
      CHECK(berries >= 4);
      // The first bunch hangs straight, like a single one.
      for (const Internode& internode : bunch.internodes)
        if (internode.kind == Kind::rachis && internode.axis < 0 && internode.start.x == 0) CHECK(internode.end.x <= 0);
      CHECK(worst_overlap(bunch) == 0);
    }
  }
}

TEST_CASE("adding an axis leaves the berries' radii where they were") {
  Profile profile = shouldered();
  const GrownBunch before = grown(request_for(profile));
  profile.length += 29;
  const GrownBunch after = grown(request_for(profile));
  std::vector<float> radii;
  for (const Berry& berry : after.berries) radii.push_back(berry.radius);
  int unchanged = 0;
  for (const Berry& berry : before.berries)
    unchanged += std::find(radii.begin(), radii.end(), berry.radius) != radii.end();
  CHECK(unchanged > 0.8 * double(before.berries.size()));
}

TEST_CASE("bad input is an error that contains the fix") {
  BunchRequest request = request_for(shouldered());
  request.m = 3;
  request.n = {1};
  auto wrong = grow(request);
  REQUIRE(!wrong);
  CHECK(wrong.error().reason == Reason::bad_input);
  CHECK(english(wrong.error().message).find("n needs m − 1 values (2)") != std::string::npos);

  request = request_for(shouldered());
  request.grammar = "axiom: A\nA --> B(x)\n";
  auto unreadable = grow(request);
  REQUIRE(!unreadable);
  CHECK(unreadable.error().line == 2);
  CHECK(unreadable.error().column > 0);

  request.grammar = "axiom: ?E(1,2)\n?E(a,b) : a=1 --> F(1)\n";
  auto unanswered = grow(request);
  REQUIRE(!unanswered);
  CHECK(english(unanswered.error().message).find("3, 5 or 6") != std::string::npos);
}

TEST_CASE("parameters out of range are clamped with a note") {
  BunchRequest request = request_for(shouldered());
  set(request, Parameter::l, 10000);
  set(request, Parameter::wing, 0.1f);
  const GrownBunch bunch = grown(request);
  CHECK(bunch.plan.m == 20);
  CHECK(bunch.second->m == 6);
  CHECK(bunch.notes.size() == 2);
}

TEST_CASE("exceeding a limit is an error") {
  BunchRequest request = request_for(shouldered());
  request.m = 1000;
  request.n.assign(999, 1000);
  auto result = grow(request);
  REQUIRE(!result);
  CHECK(result.error().reason == Reason::limit);
}
