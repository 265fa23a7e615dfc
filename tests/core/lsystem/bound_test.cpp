// A program is compiled once and bound to inputs as often as they change.
#include "foundation/english.hpp"
#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

std::shared_ptr<const lsystem::Program> program_from(std::string text) {
  auto program = sound(lsystem::compile(text, Limits{}));
  text.assign(text.size(), '?');  // a reader of the old text would see this
  return program;
}

std::string bound_and_derived(const std::shared_ptr<const lsystem::Program>& program, const Inputs& inputs) {
  const auto bound = sound(lsystem::bind(program, inputs, Limits{}));
  return text_of(*bound, derived(*bound, 4096));
}

// "reason line:column message" of binding or, when that goes well, of derivation.
std::string trouble_when_bound(std::string_view text, const Inputs& inputs, bool* when_binding = nullptr) {
  const auto bound = lsystem::bind(sound(lsystem::compile(text, Limits{})), inputs, Limits{});
  if (when_binding) *when_binding = !bound;
  Diagnostic diagnostic;
  if (bound) {
    const auto result = lsystem::develop(*bound.value(), 1, 4096, Limits{});
    if (result) return "none";
    diagnostic = result.error();
  } else {
    diagnostic = bound.error();
  }
  return std::to_string(diagnostic.line) + ":" + std::to_string(diagnostic.column) + " " + english(diagnostic.message);
}

}  // namespace

TEST_CASE("one program serves all inputs, without its text") {
  const auto program = program_from(
      "#input m\n#input n[]\n#define k 2*m\n#define deep k>4 && n[k]>1\n"
      "axiom: A(m, k+1) V(deep)\nA(i,x) : i>0 && x>k-4 --> V(n[i]*k, x/k, min(k,m), n[m]) A(i-1, x-1)");
  CHECK(bound_and_derived(program, {{{"m", 1}}, {{"n", {5}}}}) == "V(10,1.5,1,5)A(0,2)V(0)");
  CHECK(bound_and_derived(program, {{{"m", 2}, {"k", 1}}, {{"n", {5, 6}}}}) == "V(6,2,1,6)V(5,1,1,6)A(0,0)V(0)");
  CHECK(bound_and_derived(program, {{{"m", 1}}, {{"n", {5}}}}) == "V(10,1.5,1,5)A(0,2)V(0)");
  CHECK(bound_and_derived(program, {{{"m", 3}}, {{"n", {1, 1, 1, 1, 1, 2}}}}) ==
        "V(6,1.1666666,3,1)V(6,1,3,1)V(6,0.8333333,3,1)A(0,4)V(1)");
}

TEST_CASE("binding again does not change a bound program") {
  const auto program = program_from("#input m\naxiom: A(m)\nA(x) : x<m+3 --> V(x*m) A(x+m)");
  const auto two = sound(lsystem::bind(program, {{{"m", 2}}, {}}, Limits{}));
  const auto one = sound(lsystem::bind(program, {{{"m", 1}}, {}}, Limits{}));
  CHECK(text_of(*two, derived(*two, 9)) == "V(4)V(8)A(6)");
  CHECK(text_of(*one, derived(*one, 9)) == "V(1)V(2)V(3)A(4)");
  CHECK(lsystem::constant(*two, "m", 0) == 2);
  CHECK(lsystem::constant(*one, "m", 0) == 1);
}

TEST_CASE("a bound grammar keeps its program alive") {
  const auto bound = sound(lsystem::bind(program_from("#define a 3\naxiom: V(a)"), {}, Limits{}));
  CHECK(text_of(*bound, derived(*bound, 0)) == "V(3)");
}

TEST_CASE("an index beyond an array's end is an error only when evaluated") {
  const char* text =
      "#input m\n#input n[]\naxiom: A(m)\n"
      "A(i) : i>3 --> S(n[m]-9) B(n[m]+1)\nA(i) : i=2 && n[m]>0 --> F(n[m])\nA(i) : i=1 || n[9]>0 --> V(n[1])";
  const Inputs::Array list{"n", {7, 8, 9}};
  bool when_binding = true;
  CHECK(trouble_when_bound(text, {{{"m", 5}}, {list}}, &when_binding) ==
        "4:18 “n[5]” does not exist; the index must be a whole number from 1 to 3.");
  CHECK_FALSE(when_binding);
  CHECK(trouble_when_bound(text, {{{"m", 1}}, {{"n", {20}}}}) == "none");
  CHECK(trouble_when_bound(text, {{{"m", 2}}, {{"n", {20}}}}) ==
        "5:15 “n[2]” does not exist; the index must be a whole number from 1 to 1.");
  CHECK(trouble_when_bound(text, {{{"m", 0}}, {{"n", {20}}}}) ==
        "6:15 “n[9]” does not exist; the index must be a whole number from 1 to 1.");
}

TEST_CASE("turtle arguments that inputs make not finite are errors of bind, at every place") {
  const char* text = "#input m\naxiom: F\nA(i) --> S(m-2)\nB(i) : i>m --> F(i) F(1/m)";
  bool when_binding = false;
  CHECK(trouble_when_bound(text, {{{"m", 1}}, {}}, &when_binding) ==
        "3:12 The argument of “S” must be 0 or greater, but it is -1.");
  CHECK(when_binding);
  CHECK(trouble_when_bound(text, {{{"m", 3}}, {}}) == "none");
  CHECK(trouble_when_bound("#input m\naxiom: F(1/m)", {{{"m", 0}}, {}}) ==
        "2:10 The argument of “F” must be a finite number, but it is ∞.");
  CHECK(trouble_when_bound("#input m\n#define k 1/m\naxiom: F", {{{"m", 0}}, {}}) ==
        "2:11 “k” evaluates to ∞; it must be a finite number.");
  CHECK(trouble_when_bound("#input n[]\n#define k n[3]\naxiom: F", {{}, {{"n", {1}}}}) ==
        "2:11 “n[3]” does not exist; the index must be a whole number from 1 to 1.");
  CHECK(trouble_when_bound("#input n[]\n#define k n[3]\naxiom: F", {{{"k", 1}}, {{"n", {1}}}}) == "none");
}
