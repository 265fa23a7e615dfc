// How many steps a grammar takes: as the request sets, else as the text sets, else until nothing is rewritten.
#include "foundation/english.hpp"
#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

std::string developed(std::string_view text, std::optional<std::uint32_t> steps, const Inputs& inputs = {}) {
  const BoundPointer bound = compiled(text, inputs);
  return text_of(*bound, sound(lsystem::develop(*bound, 1, steps, Limits{})));
}

std::string refused(std::string_view text, std::optional<std::uint32_t> steps, const Inputs& inputs = {}) {
  const auto bound = lsystem::bind(sound(lsystem::compile(text, Limits{})), inputs, Limits{});
  if (!bound)
    return std::to_string(bound.error().line) + ":" + std::to_string(bound.error().column) + " " +
           english(bound.error().message);
  const auto derived = lsystem::develop(*bound.value(), 1, steps, Limits{});
  REQUIRE_FALSE(derived);
  CHECK(derived.error().reason == Reason::limit);
  return english(derived.error().message);
}

}  // namespace

TEST_CASE("the request's steps win over the text's, and without either a grammar grows to its end") {
  const char* text = "derivation length: 2\naxiom: A(5)\nA(i) : i>0 --> F A(i-1)";
  CHECK(developed(text, {}) == "F F A(3)");
  CHECK(developed(text, 3) == "F F F A(2)");
  CHECK(developed(text, 100) == "F F F F F A(0)");
  CHECK(developed("axiom: A(5)\nA(i) : i>0 --> F A(i-1)", {}) == "F F F F F A(0)");
  CHECK(lsystem::derivation_length(*compiled(text)) == 2);
  CHECK_FALSE(lsystem::derivation_length(*compiled("axiom: A")).has_value());
}

TEST_CASE("no steps leave the axiom") {
  const char* text = "derivation length: 0\naxiom: A [ B % C ]\nA --> F";
  CHECK(developed(text, {}) == "A[B%C]");
  CHECK(developed(text, 0) == "A[B%C]");
  CHECK(developed(text, 1) == "F[B]");
}

TEST_CASE("a text that never ends grows for the requested steps") {
  CHECK(developed("derivation length: 3\naxiom: A\nA --> F A", {}) == "F F F A");
  const BoundPointer bound = compiled("derivation length: 4096\naxiom: A\nA --> A");
  CHECK(sound(lsystem::develop(*bound, 1, {}, Limits{})).steps == 4096);
}

TEST_CASE("a derivation length may depend on constants, and may be at any place of the text") {
  const char* text = "#input age\n#define k 2\naxiom: A\nderivation length: k*age\nA --> F A";
  CHECK(developed(text, {}, {{{"age", 2}}, {}}) == "F F F F A");
  CHECK(developed(text, {}, {{{"age", 1}, {"k", 1}}, {}}) == "F A");
  CHECK(developed("axiom: A\nA --> F\n  A\nderivation length: 1\nB --> C", {}) == "F A");
}

TEST_CASE("a derivation length is a whole number within the limit") {
  const char* text = "#input age\naxiom: A\nderivation length: age/2\nA --> A";
  CHECK(refused(text, {}, {{{"age", 3}}, {}}) ==
        "3:20 The derivation length evaluates to 1.5; it must be a whole number, 0 or greater.");
  CHECK(refused(text, {}, {{{"age", -2}}, {}}) ==
        "3:20 The derivation length evaluates to -1; it must be a whole number, 0 or greater.");
  CHECK(refused(text, {}, {{{"age", 8194}}, {}}) ==
        "3:20 The derivation length evaluates to 4097; the limit is 4096 steps.");
  CHECK(refused("axiom: A\nderivation length: 0/0", {}) ==
        "2:20 The derivation length evaluates to NaN; it must be a whole number, 0 or greater.");
  CHECK(refused("axiom: A\nA --> A", 4097) == "The request is for 4097 steps; the limit is 4096. Request fewer steps.");
}

TEST_CASE("the last step that rewrote anything is counted, and the modules of all strings") {
  const Derived derived = sound(lsystem::develop(*compiled("axiom: A(3)\nA(i) : i>0 --> F A(i-1)"), 1, 50, Limits{}));
  CHECK(derived.steps == 3);
  CHECK(derived.modules_written == 2 + 3 + 4);
}
