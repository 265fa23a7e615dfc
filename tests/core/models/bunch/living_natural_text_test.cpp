// The natural bunch too is the interpretation of its text: edit it, and the bunch follows, or a note lists the ignored
// part (docs/natural.md).
#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "foundation/english.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

GrownBunch grown(const std::string& grammar, float count = 0, float age = 100) {
  REQUIRE(!grammar.empty());
  BunchRequest request = natural_request(table3[1].profile());
  if (count > 0) set(request, Parameter::count, count);
  set(request, Parameter::age, age);
  request.grammar = grammar;
  auto result = grow(request);
  REQUIRE_MESSAGE(result, (result ? "" : result.error().message));
  return std::move(result.value());
}

GrownBunch as_it_stands() { return grown(std::string(builtin_grammar(4))); }

std::size_t count_kind(const GrownBunch& bunch, Kind kind) {
  return static_cast<std::size_t>(std::count_if(bunch.internodes.begin(), bunch.internodes.end(),
                                                [kind](const Internode& one) { return one.kind == kind; }));
}

void check_no_gaps(const GrownBunch& bunch) {
  for (const Internode& one : bunch.internodes)
    if (one.parent >= 0) CHECK(one.start == bunch.internodes[static_cast<std::size_t>(one.parent)].end);
}

bool has_note(const GrownBunch& bunch, std::string_view words) {
  return std::any_of(bunch.notes.begin(), bunch.notes.end(),
                     [words](const std::string& note) { return english(note).find(words) != std::string::npos; });
}

// Internodes of no role on which nothing grows.
std::size_t barren_axes(const GrownBunch& bunch) {
  std::vector<std::uint8_t> has_child(bunch.internodes.size(), 0);
  for (const Internode& one : bunch.internodes)
    if (one.parent >= 0) has_child[static_cast<std::size_t>(one.parent)] = 1;
  std::size_t barren = 0;
  for (std::size_t i = 0; i < has_child.size(); ++i) barren += bunch.internodes[i].kind == Kind::axis && !has_child[i];
  return barren;
}

// Length of the last internodes of the rachis over that of the first, below the peduncle.
float closing(const GrownBunch& bunch) {
  std::vector<float> lengths;
  for (const Internode& one : bunch.internodes)
    if (one.kind == Kind::rachis && one.start.y <= 0) lengths.push_back(glm::length(one.end - one.start));
  REQUIRE(lengths.size() > 4);
  return lengths[lengths.size() - 2] / lengths[0];  // the last one is the remainder
}

const std::string pedicel_line = "Ap(w,s) --> ?E(1,0,0,stalk*(1+vary*(ran(0.4)-0.2)),w,s)";
const std::string answered_pedicel_line = "type=1        --> +(theta) &(phi) !(w) F(l) S(b)";

}  // namespace

TEST_CASE("`near` and `tip` of the text place the nodes, and the plan follows") {
  const GrownBunch plain = as_it_stands();
  const GrownBunch near = grown(edited(4, "#define near 0.6", "#define near 0.2"));
  CHECK(closing(near) < 0.6f * closing(plain));
  CHECK(count_kind(near, Kind::rachis) > count_kind(plain, Kind::rachis));
  const GrownBunch even = grown(edited(4, "#define near 0.6", "#define near 1"));
  CHECK(closing(even) == doctest::Approx(1).epsilon(0.02));
  const GrownBunch early = grown(edited(4, "#define tip 0.4", "#define tip 0.9"));
  CHECK(count_kind(early, Kind::rachis) > count_kind(plain, Kind::rachis));
  for (const GrownBunch* bunch : {&near, &even, &early}) CHECK(bunch->counts.berries > 40);
}

TEST_CASE("a yaw of the text turns axes and twigs") {
  const auto droop = [](const GrownBunch& bunch) {
    float sum = 0;
    int axes = 0;
    for (const Internode& one : bunch.internodes)
      if (one.kind == Kind::end) {
        const glm::vec3 along = glm::normalize(one.end - one.start);
        sum -= along.y;
        ++axes;
      }
    return sum / static_cast<float>(axes);
  };
  CHECK(droop(grown(edited(4, "#define alpha_y 60", "#define alpha_y 20"))) > droop(as_it_stands()) + 0.1f);
}

TEST_CASE("a text may use more axes than the plan has") {
  CHECK(grown(edited(4, "aim[k]", "aim[k+60]")).counts.berries > 20);
  CHECK(grown(edited(4, "arm[k]", "arm[k+60]")).counts.berries > 20);
}

TEST_CASE("a count is met with as many flowers to an end structure as the text has") {
  const std::string two = edited(4, "  [ /(vary*(ran(50)-25)) -(alpha_y+vary*(ran(30)-15)) Ap(fine, s) ]\n", "");
  for (const float count : {60.0f, 110.0f}) {
    const GrownBunch bunch = grown(two, count);
    CHECK(std::abs(static_cast<float>(bunch.counts.berries) - count) <= 0.03f * count + 0.5f);
    CHECK(bunch.notes.empty());
  }
}

TEST_CASE("a thorn in Ap is drawn beside the pedicel, and is no pedicel") {
  const GrownBunch plain = as_it_stands();
  const GrownBunch thorny =
      grown(edited(4, pedicel_line, "Ap(w,s) --> [ +(90) F(9) ] ?E(1,0,0,stalk*(1+vary*(ran(0.4)-0.2)),w,s)"));
  CHECK(barren_axes(plain) == 0);
  CHECK(barren_axes(thorny) > plain.berries.size());
  CHECK(thorny.counts.pedicels == thorny.counts.berries + thorny.counts.withered);
  CHECK(std::abs(static_cast<float>(thorny.counts.berries) - static_cast<float>(plain.counts.berries)) <
        0.1f * static_cast<float>(plain.counts.berries));
  check_no_gaps(thorny);
  // A thorn on the pedicel itself moves with it.
  const GrownBunch spiny =
      grown(edited(4, answered_pedicel_line, "type=1        --> +(theta) &(phi) !(w) F(l) [ +(90) F(9) ] S(b)"));
  CHECK(spiny.counts.pedicels == plain.counts.pedicels);
  CHECK(spiny.internodes.size() == plain.internodes.size() + plain.counts.pedicels);
  check_no_gaps(spiny);
}

TEST_CASE("a text without S shows its stems, with a note about the missing flowers") {
  const GrownBunch bare = grown(edited(4, "F(l) S(b)", "F(l)"));
  CHECK(bare.counts.berries == 0);
  CHECK(count_kind(bare, Kind::pedicel) > 100);
  CHECK(count_kind(bare, Kind::end) > 30);
  CHECK(has_note(bare, "has no flowers"));
  check_no_gaps(bare);
}

TEST_CASE("two S on a pedicel are two berries, with ids and places of their own") {
  const GrownBunch plain = grown(std::string(builtin_grammar(4)), 0, 5);  // in flower, before any has fallen
  const GrownBunch twins = grown(edited(4, "F(l) S(b)", "F(l) [ +(30) S(b) ] [ -(30) S(b) ]"), 0, 5);
  CHECK(twins.counts.berries == 2 * plain.counts.berries);
  CHECK(twins.counts.pedicels == plain.counts.pedicels);
  std::set<std::uint32_t> ids;
  for (const Berry& berry : twins.berries) CHECK(ids.insert(berry.id).second);
  for (const Berry& berry : plain.berries) CHECK(ids.count(berry.id) == 1);
  const GrownBunch ripe = grown(edited(4, "F(l) S(b)", "F(l) [ +(30) S(b) ] [ -(30) S(b) ]"));
  CHECK(ripe.counts.berries > 40);
  check_no_gaps(ripe);
}

TEST_CASE("three F in a row are three internodes of one pedicel, without gaps when it bends") {
  const GrownBunch plain = as_it_stands();
  const GrownBunch thirds = grown(edited(4, "!(w) F(l) S(b)", "!(w) F(l/3) F(l/3) F(l/3) S(b)"));
  CHECK(count_kind(thirds, Kind::pedicel) == 3 * thirds.counts.pedicels);
  CHECK(std::abs(static_cast<float>(thirds.counts.berries) - static_cast<float>(plain.counts.berries)) < 4);
  check_no_gaps(thirds);
  for (std::size_t i = 0; i < thirds.internodes.size(); ++i) {
    const Internode& one = thirds.internodes[i];
    if (!one.joint || one.kind != Kind::pedicel) continue;
    const Internode& before = thirds.internodes[static_cast<std::size_t>(one.parent)];
    const glm::vec3 a = one.end - one.start, b = before.end - before.start;
    CHECK(glm::length(a - b) < 1e-5f);  // metres
  }
  const GrownBunch stems = grown(edited(4, "!(w*r_w) F(l)", "!(w*r_w) F(l/2) F(l/2)"));
  CHECK(std::abs(static_cast<float>(stems.counts.end_structures) - static_cast<float>(plain.counts.end_structures)) <
        4);
  check_no_gaps(stems);
}

TEST_CASE("a ball that hangs on no line is left out with a note") {
  const GrownBunch bunch = grown(edited(4, "axiom: Ar", "axiom: S(1) Ar"));
  CHECK(bunch.counts.berries > 40);
  CHECK(has_note(bunch, "is not on a line"));
  CHECK(as_it_stands().notes.empty());
}

TEST_CASE("both procedures note a parameter that the text does not use") {
  for (const int procedure : {0, 1}) {
    BunchRequest request = natural_request(table3[1].profile());
    set(request, Parameter::procedure, static_cast<float>(procedure));
    set(request, Parameter::vary, 0.5f);
    request.grammar = "axiom: F(50) [ F(40) S(10) ]";
    const auto result = grow(request);
    REQUIRE(result);
    CHECK(has_note(result.value(), "no “#define vary”"));
  }
  // The natural plan uses w_i, which its text does not have.
  BunchRequest stout = natural_request(table3[1].profile());
  set(stout, Parameter::wi, 20);
  const auto result = grow(stout);
  REQUIRE(result);
  CHECK(result->notes.empty());
}
