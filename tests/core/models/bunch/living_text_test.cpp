// The bunch is the interpretation of the grammar's text: edit the text, and the bunch follows (docs/bunch.md).
#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "foundation/english.hpp"
#include "models/bunch/measures/measures.generated.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

GrownBunch grown(BunchRequest request, const std::string& grammar) {
  REQUIRE(!grammar.empty());
  request.grammar = grammar;
  auto result = grow(request);
  if (!result) FAIL(result.error().message);
  return std::move(result.value());
}

const BunchRequest& roomy() {
  static const BunchRequest request = [] {
    BunchRequest r = as_printed(table3[1].profile());
    set_radius(r, 2, 3);
    return r;
  }();
  return request;
}

double mean_berries(const std::string& grammar, float radius) {
  double sum = 0;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    BunchRequest request = as_printed(table3[1].profile(), seed);
    set_radius(request, radius * 0.8f, radius * 1.2f);
    sum += grown(request, grammar).counts.berries;
  }
  return sum / 20;
}

}  // namespace

TEST_CASE("both procedures note statements of a text without effect") {
  for (const int number : {3, 4}) {
    BunchRequest request = number == 3 ? roomy() : natural_request(table3[1].profile());
    const std::string text = std::string(builtin_grammar(number)) + "\nAz --> F7\n";
    const std::vector<std::string> notes = grown(request, text).notes;
    CHECK(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
      return english(note).find("“F7” is read as a single symbol") != std::string::npos;
    }));
  }
}

TEST_CASE("two pedicels in p8 give 2 A + Z pedicels") {
  const std::string two =
      edited(3, "  [ /(vary*(ran(50)-25)) -(alpha_y+vary*(ran(30)-15)) \\(alpha_r) Ap(l*r_p, w*r_w) ]\n", "");
  const GrownBunch bunch = grown(roomy(), two);
  CHECK(bunch.counts.cut == 0);
  CHECK(bunch.counts.end_structures == 40);
  CHECK(bunch.counts.pedicels == 80);
}

TEST_CASE("rachis and lateral brackets swapped in p1 to p4 place the laterals first and leave fewer berries") {
  std::string text(builtin_grammar(3));
  const std::string lateral =
      "  [ /(vary*(ran(50)-25)) +(alpha_y+vary*(ran(30)-15)) Af(n[i-1], l*r_rf*reach[i-1], w*r_w) ]\n";
  for (const char* rachis : {"  [ // Ar2(i-1, l*r_rr, w*r_w) ]\n", "  [ / Ar3(i-1, l*r_rr, w*r_w) ]\n",
                             "  [ // Ar4(i-1, l*r_rr, w*r_w) ]\n", "  [ \\ Ar1(i-1, l*r_rr, w*r_w) ]\n"}) {
    const std::size_t at = text.find(rachis + lateral);
    REQUIRE(at != std::string::npos);
    text.replace(at, std::string(rachis).size() + lateral.size(), lateral + rachis);
  }
  // The second internode drawn belongs to the topmost axis, no longer to the rachis.
  const BunchRequest request = as_printed(table3[1].profile());
  CHECK(grown(request, std::string(builtin_grammar(3))).internodes[1].kind == Kind::rachis);
  CHECK(grown(request, text).internodes[1].axis == 0);

  for (const float radius : {20.0f, 25.0f, 30.0f}) {
    const double printed = mean_berries(std::string(builtin_grammar(3)), radius), swapped = mean_berries(text, radius);
    MESSAGE("berries at radius " << radius << ": " << printed << " as printed, " << swapped << " swapped");
    CHECK(swapped < printed);
  }
}

TEST_CASE("without p7b the redcurrant keeps only its tip") {
  const std::string text = edited(3, "Af(i,l,w) : i<1 --> Ap(l*r_e*r_p, w*r_w)\n", "");
  const GrownBunch bunch = grown(as_printed(table3[9].profile()), text);
  CHECK(bunch.counts.pedicels == 3);
}

TEST_CASE("without yaw all pedicels are collinear with their axis") {
  BunchRequest request = roomy();
  set(request, Parameter::sag, 0);
  set(request, Parameter::t, 0);
  const GrownBunch bunch = grown(request, edited(3, "#define alpha_y 60", "#define alpha_y 0"));
  std::size_t pedicels = 0;
  for (const Internode& internode : bunch.internodes) {
    const glm::vec3 along = glm::normalize(internode.end - internode.start);
    CHECK(along.y == doctest::Approx(-1));
    pedicels += internode.kind == Kind::pedicel;
  }
  CHECK(pedicels > 0);
}

TEST_CASE("the constants of the text are the parameter table's defaults, and a parameter replaces them") {
  const std::string text(builtin_grammar(3));
  for (const ParameterInfo& info : parameter_table) {
    if (info.define.empty()) continue;
    CAPTURE(info.define);
    const std::string define = "#define " + std::string(info.define) + " ";
    const std::size_t at = text.find(define);
    REQUIRE(at != std::string::npos);
    CHECK(std::stof(text.substr(at + define.size())) == info.standard);
  }
  BunchRequest longer = roomy();
  set(longer, Parameter::li, 100);
  const auto drop = [](const GrownBunch& bunch) {
    float y = 0;
    for (const Internode& internode : bunch.internodes) y = std::fmin(y, internode.end.y);
    return y;
  };
  const std::string builtin(builtin_grammar(3));
  CHECK(drop(grown(longer, builtin)) < 1.8f * drop(grown(roomy(), builtin)));
}

TEST_CASE("the measured outline uses the text's own rates") {
  // The same bunch, once by its text and once by a parameter.
  BunchRequest request = request_for(table3[4].profile());
  request.measures = true;
  const GrownBunch by_text = grown(request, edited(3, "#define r_e 0.6", "#define r_e 1.1"));
  set(request, Parameter::re, 1.1f);
  const GrownBunch by_parameter = grown(request, std::string(builtin_grammar(3)));
  REQUIRE(by_text.fingerprint == by_parameter.fingerprint);
  const auto coverage = [](const GrownBunch& bunch) {
    return bunch.measures[static_cast<std::size_t>(Measure::coverage)];
  };
  CHECK(coverage(by_text) == coverage(by_parameter));
  CHECK(coverage(by_text) != coverage(grown(request_for(table3[4].profile()), std::string(builtin_grammar(3)))));
}
