// Traces of derivations, worked out by hand.
#include "foundation/english.hpp"
#include "lsystem/derivation_traces.hpp"

using namespace panicle;
using namespace panicle::tests;
using lsystem::DerivationTrace;
using lsystem::TraceEntry;

namespace {

// Answers every ?E(r, n) with n + r.
class Adding : public Drawn {
 public:
  void query(const Turtle&, std::span<float> parameters, const Lineage&) override { parameters[1] += parameters[0]; }
};

std::string spans(const DerivationTrace& trace, lsystem::ModuleSpan TraceEntry::* which) {
  std::string text;
  for (const TraceEntry& each : trace.modules())
    text += std::to_string((each.*which).first) + "+" + std::to_string((each.*which).count) + " ";
  return text;
}

std::string parents(const DerivationTrace& trace) {
  std::string text;
  for (const TraceEntry& each : trace.modules())
    text += each.parent == TraceEntry::none ? "- " : std::to_string(each.parent) + " ";
  return text;
}

std::string lines(const DerivationTrace& trace, expression::SourceLocation TraceEntry::* place) {
  std::string text;
  for (const TraceEntry& each : trace.modules())
    text += std::to_string((each.*place).line) + ":" + std::to_string((each.*place).column) + " ";
  return text;
}

std::string joined(const DerivationTrace& trace, std::string TraceEntry::* what, const char* between = " ") {
  std::string text;
  for (const TraceEntry& each : trace.modules()) text += each.*what + between;
  return text;
}

}  // namespace

TEST_CASE("a trace has parents, children and descendants, checked by hand") {
  // A → A B, B → A: F of ABOP 1.2's filament, with a copied F between.
  const BoundPointer bound = compiled("axiom: A F B\nA --> A B\n  B --> A\n");
  const DerivationTrace axiom = traced(*bound, 3, {.step = 0});
  CHECK(axiom.counts() == std::vector<std::uint32_t>{3, 4, 6, 9});
  CHECK(joined(axiom, &TraceEntry::text) == "A F B ");
  CHECK(parents(axiom) == "- - - ");
  CHECK(lines(axiom, &TraceEntry::production) == "0:0 0:0 0:0 ");
  CHECK(lines(axiom, &TraceEntry::fires) == "2:1 0:0 3:3 ");
  CHECK(spans(axiom, &TraceEntry::children) == "0+2 2+1 3+1 ");
  CHECK(spans(axiom, &TraceEntry::last) == "0+5 5+1 6+3 ");

  const DerivationTrace second = traced(*bound, 3, {.step = 2});
  CHECK(joined(second, &TraceEntry::text) == "A B A F A B ");
  CHECK(parents(second) == "0 0 1 2 3 3 ");
  CHECK(lines(second, &TraceEntry::production) == "2:1 2:1 3:3 0:0 2:1 2:1 ");
  CHECK(spans(second, &TraceEntry::children) == "0+2 2+1 3+2 5+1 6+2 8+1 ");
  CHECK(spans(second, &TraceEntry::last) == "0+2 2+1 3+2 5+1 6+2 8+1 ");

  // Of the last string nothing becomes anything, and each module is its own descendant.
  const DerivationTrace last = traced(*bound, 3, {.step = 3});
  CHECK(lines(last, &TraceEntry::fires) == "0:0 0:0 0:0 0:0 0:0 0:0 0:0 0:0 0:0 ");
  CHECK(spans(last, &TraceEntry::children) == "0+0 0+0 0+0 0+0 0+0 0+0 0+0 0+0 0+0 ");
  CHECK(spans(last, &TraceEntry::last) == "0+1 1+1 2+1 3+1 4+1 5+1 6+1 7+1 8+1 ");
}

TEST_CASE("a trace's window is a part of its step's string, and a step beyond the last is the last") {
  const BoundPointer bound = compiled("axiom: A F B\nA --> A B\nB --> A\n");
  const DerivationTrace part = traced(*bound, 3, {.step = 2, .first = 3, .count = 2});
  CHECK(joined(part, &TraceEntry::text) == "F A ");
  CHECK(parents(part) == "2 3 ");
  CHECK(spans(part, &TraceEntry::children) == "5+1 6+2 ");
  CHECK(spans(part, &TraceEntry::last) == "5+1 6+2 ");
  CHECK(traced(*bound, 3, {.step = 2, .first = 6}).modules().empty());
  CHECK(traced(*bound, 3, {.step = 1, .first = 0xffffffff}).modules().empty());
  CHECK(traced(*bound, 3, {.step = 1, .count = 0}).modules().empty());
  const DerivationTrace beyond = traced(*bound, 3, {.step = 4000, .first = 8});
  CHECK(beyond.step() == 3);
  CHECK(joined(beyond, &TraceEntry::text) == "A ");
}

TEST_CASE("a trace has a production's values: formals, contexts and blocks") {
  const BoundPointer bound =
      compiled("axiom: L(1) A(2) R(3)\nL(p) < A(x) > R(q) : {s = x+p+q; t = s/4} s>5 {t = t*2; u = x} --> A(t)\n");
  const DerivationTrace trace = traced(*bound, 1, {});
  CHECK(joined(trace, &TraceEntry::values, "|") == "|x=2 p=1 q=3 s=6 t=3 u=2||");
  CHECK(lines(trace, &TraceEntry::fires) == "0:0 2:8 0:0 ");
  CHECK(joined(traced(*bound, 1, {.step = 1}), &TraceEntry::text) == "L(1) A(3) R(3) ");
}

TEST_CASE("a trace has the weights and the draw of a weighted choice") {
  const BoundPointer bound =
      compiled("axiom: A A A A A A A A A A A A A A A A F\nA --> B : 1\nA --> C : 2.5\nA --> D : 0.5");
  const DerivationTrace trace = traced(*bound, 1, {});
  const DerivationTrace after = traced(*bound, 1, {.step = 1});
  std::string seen;
  for (std::size_t i = 0; i < 16; ++i) {
    const TraceEntry& module = trace.modules()[i];
    const auto [total, weight, drawn] = module.chance;
    CHECK(total == 4);
    const std::string& became = after.modules()[i].text;
    CHECK(weight == (became == "B" ? 1 : became == "C" ? 2.5f : 0.5f));
    CHECK(drawn >= (became == "B" ? 0 : became == "C" ? 1 : 3.5f));
    CHECK(drawn < (became == "B" ? 1 : became == "C" ? 3.5f : 4));
    CHECK(after.modules()[i].production.line == (became == "B" ? 2 : became == "C" ? 3 : 4));
    CHECK(module.fires.line == after.modules()[i].production.line);
    seen += became;
  }
  CHECK(seen.find('B') != std::string::npos);
  CHECK(seen.find('C') != std::string::npos);
  CHECK(trace.modules()[16].chance == std::array<float, 3>{});
}

TEST_CASE("a cut leaves nothing of the rest of its branch") {
  const BoundPointer bound = compiled("axiom: [ A F [ F ] B ] A\nA --> F %\n");
  const DerivationTrace first = traced(*bound, 2, {.step = 1});
  CHECK(joined(first, &TraceEntry::text) == "[ F % F [ F ] B ] F % ");
  CHECK(spans(first, &TraceEntry::children) == "0+1 1+1 2+0 2+0 2+0 2+0 2+0 2+0 2+1 3+1 4+0 ");
  CHECK(spans(first, &TraceEntry::last) == "0+1 1+1 2+0 2+0 2+0 2+0 2+0 2+0 2+1 3+1 4+0 ");
  CHECK(lines(first, &TraceEntry::fires) == "0:0 0:0 0:0 0:0 0:0 0:0 0:0 0:0 0:0 0:0 0:0 ");
  CHECK(spans(traced(*bound, 2, {}), &TraceEntry::last) == "0+1 1+1 2+0 2+0 2+0 2+0 2+0 2+1 3+1 ");
  const DerivationTrace trailed = traced(*bound, 2, {.module = 3});
  CHECK(trailed.trail() == std::vector<std::uint32_t>{8, 9, 3});
}

TEST_CASE("the production of a decomposed module is the one that decomposed it") {
  const BoundPointer bound = compiled(
      "axiom: A(2)\nA(n) : n>0 --> M(n) A(n-1) G\ndecomposition\nmaximum depth: 3\nM(n) --> N(n) F\nN(n) : n>1 --> H "
      "H\n");
  const DerivationTrace trace = traced(*bound, 2, {.step = 1});
  CHECK(joined(trace, &TraceEntry::text) == "H H F A(1) G ");
  CHECK(lines(trace, &TraceEntry::production) == "6:1 6:1 5:1 2:1 2:1 ");
  CHECK(parents(trace) == "0 0 0 0 0 ");
  CHECK(joined(traced(*bound, 2, {}), &TraceEntry::values, "|") == "n=2|");
  CHECK(spans(traced(*bound, 2, {}), &TraceEntry::children) == "0+5 ");
  CHECK(joined(trace, &TraceEntry::values, "|") == "|||n=1||");
  // An axiom is decomposed as well.
  const BoundPointer axiom = compiled("axiom: F M\nF --> F\ndecomposition\nM --> G F");
  CHECK(lines(traced(*axiom, 1, {.first = 1}), &TraceEntry::production) == "4:1 4:1 ");
  CHECK(lines(traced(*axiom, 1, {}), &TraceEntry::production) == "0:0 4:1 4:1 ");
}

TEST_CASE("a trace has the values written by turtle queries, and query and response of the environment") {
  const BoundPointer located = compiled("axiom: F(2) ?P(0,0,0) A\nA --> F(1) ?H(0,0,0)\n");
  CHECK(joined(traced(*located, 1, {}), &TraceEntry::response, "|") == "|written 0 -2 0||");
  CHECK(joined(traced(*located, 1, {.step = 1, .first = 3}), &TraceEntry::response, "|") == "written 0 -1 0|");

  const BoundPointer open = compiled("derivation length: 9\naxiom: ?E(2,5)\n?E(r,n) : n<20 --> F ?E(r,n*2)\n");
  Adding adding;
  const lsystem::DerivationOptions options{{}, nullptr, &adding};
  const DerivationTrace axiom = traced(*open, 3, {}, options);
  CHECK(joined(axiom, &TraceEntry::text) == "?E(2,5) ");
  CHECK(joined(axiom, &TraceEntry::response) == "asked 2 5 → 2 7 ");
  CHECK(joined(axiom, &TraceEntry::values) == "r=2 n=7 ");
  const DerivationTrace first = traced(*open, 3, {.step = 1}, options);
  CHECK(joined(first, &TraceEntry::text) == "F ?E(2,14) ");
  CHECK(joined(first, &TraceEntry::response, "|") == "|asked 2 14 → 2 16|");
  // Then it is 32 and 34, which nothing rewrites: the last string has the answer.
  const DerivationTrace last = traced(*open, 3, {.step = 9}, options);
  CHECK(last.step() == 3);
  CHECK(joined(last, &TraceEntry::text) == "F F ?E(2,34) ");
}

TEST_CASE("productions of sub-L-systems are traced with their places in the text") {
  const BoundPointer bound = compiled(
      "Lsystem: main\naxiom: A(1) [ ?leaf(2) A(5) ]\nA(n) --> A(n+1)\nendlsystem\n"
      "Lsystem: leaf\nA(n) --> F A(n*2)\nendlsystem\n");
  const DerivationTrace trace = traced(*bound, 1, {});
  CHECK(joined(trace, &TraceEntry::text) == "A(1) [ ?leaf(2) A(5) ] ");
  CHECK(joined(trace, &TraceEntry::values, "|") == "n=1|||n=5||");
  CHECK(lines(trace, &TraceEntry::fires) == "3:1 0:0 0:0 6:1 0:0 ");
  CHECK(joined(traced(*bound, 1, {.step = 1}), &TraceEntry::text) == "A(2) [ ?leaf(2) F A(10) ] ");
}

TEST_CASE("modules with random conditions may wait, and each step traces those rewritten") {
  const BoundPointer bound = compiled("derivation length: 6\naxiom: A A A A A A\nA : ran(1)<0.4 --> B\n");
  std::string before = "A A A A A A ";
  for (std::uint32_t step = 0; step < 6; ++step) {
    const DerivationTrace trace = traced(*bound, {}, {.step = step});
    if (trace.step() < step) break;
    CHECK(joined(trace, &TraceEntry::text) == before);
    before.clear();
    for (const TraceEntry& module : trace.modules()) {
      CHECK((module.text == "A" || module.fires.line == 0));
      before += module.fires.line == 3 ? "B " : module.text + " ";
    }
  }
  CHECK(before.find('B') != std::string::npos);
}

TEST_CASE("final steps without changes are not traced") {
  // B looks for a C for as long as steps are taken.
  const BoundPointer bound = compiled("axiom: A\nA --> B\nB > C --> F");
  CHECK(traced(*bound, {}, {}).counts() == std::vector<std::uint32_t>{1, 1});
  CHECK(traced(*bound, 9, {.step = 9}).step() == 1);
}

TEST_CASE("a derivation that a limit ends is traced up to the last whole step") {
  const BoundPointer bound = compiled("axiom: A\nA --> A A\n");
  Limits limits;
  limits.words = 100;
  const auto trace =
      lsystem::trace_derivation(*bound, 1, 20, limits, {}, {.step = 20, .first = 3, .count = 2, .module = 7});
  REQUIRE(trace);
  CHECK(trace->stopped().reason == Reason::limit);
  CHECK(trace->step() == 6);
  CHECK(trace->counts().back() == 64);
  CHECK(spans(trace.value(), &TraceEntry::last) == "3+1 4+1 ");
  CHECK(spans(trace.value(), &TraceEntry::children) == "0+0 0+0 ");
  CHECK(lines(trace.value(), &TraceEntry::fires) == "0:0 0:0 ");
  CHECK(trace->trail() == std::vector<std::uint32_t>{0, 0, 0, 0, 1, 3, 7});
}

TEST_CASE("responses that are drawn in place are traced for the last string") {
  const BoundPointer bound = compiled("axiom: A ?E(1,5) F\nA --> [ ?E(2,6) ]\n?E(r,n) : n>7 --> F(n)\n");
  DerivationTrace trace = traced(*bound, {}, {.step = 1});
  CHECK(joined(trace, &TraceEntry::text) == "[ ?E(2,6) ] ?E(1,5) F ");
  CHECK(lines(trace, &TraceEntry::fires) == "0:0 0:0 0:0 0:0 0:0 ");
  const Derived derived = sound(lsystem::develop(*bound, 1, {}, Limits{}));
  Adding adding;
  trace.watch_drawing(derived.string);
  REQUIRE(lsystem::interpret(*bound, *derived.string, {}, adding, 1, Limits{}, nullptr, &trace));
  CHECK(lines(trace, &TraceEntry::fires) == "0:0 3:1 0:0 0:0 0:0 ");
  CHECK(trace.modules()[1].values == "r=2 n=8");
  CHECK(spans(trace, &TraceEntry::children) == "0+0 0+0 0+0 0+0 0+0 ");
  trace.add_response(1, "asked 2 6 → 2 8; because");
  trace.add_response(77, "nobody's");
  CHECK(trace.modules()[1].response == "asked 2 6 → 2 8; because");
}

TEST_CASE("a trace that does not watch the drawing has no responses from it") {
  const BoundPointer bound = compiled("axiom: A(9)\nA(n) : n>0 --> ?E(2,6) A(n-1)\n?E(r,n) : n>7 --> F(n)\n");
  Limits limits;
  limits.steps = 3;
  auto trace = lsystem::trace_derivation(*bound, 1, {}, limits, {}, {.step = 9});
  REQUIRE(trace);
  CHECK(trace->stopped().reason == Reason::limit);
  CHECK(trace->counts().back() == 4);
  const Derived derived = sound(lsystem::develop(*bound, 1, {}, Limits{}));
  Adding adding;
  REQUIRE(lsystem::interpret(*bound, *derived.string, {}, adding, 1, Limits{}, nullptr, &trace.value()));
  CHECK(!trace->has(0));
  trace->add_response(0, "of another module");
  CHECK(lines(trace.value(), &TraceEntry::fires) == "0:0 0:0 0:0 0:0 ");
  CHECK(joined(trace.value(), &TraceEntry::response, "") == "");
}

TEST_CASE("wherever a limit ends a derivation, its trace ends with the string that is derived") {
  // ?P has the turtle's place written into it after each step, which can come to the limit as well.
  const BoundPointer bound = compiled("axiom: A(1) B ?P(0,0,0)\nA(x) --> F A(x+1) [ A(x) ?P(0,0,0) ]\nB --> B F");
  std::uint32_t max_steps = 0;
  for (std::uint64_t evaluations = 1; evaluations < 1500; ++evaluations) {
    Limits limits;
    limits.work = evaluations;
    CAPTURE(evaluations);
    const auto derived = lsystem::develop_so_far(*bound, 1, 12, limits, {});
    const auto traced = lsystem::trace_derivation(*bound, 1, 12, limits, {}, {.step = 0});
    REQUIRE(derived);
    REQUIRE(traced);
    CHECK(traced->stopped().reason == Reason::limit);
    CHECK(traced->counts().back() == lsystem::length(*derived->string));
    std::uint32_t descendants = 0;
    for (const TraceEntry& module : traced->modules()) descendants += module.last.count;
    if (!traced->modules().empty()) CHECK(descendants == traced->counts().back());
    max_steps = std::max(max_steps, traced->steps());
  }
  CHECK(max_steps > 4);
}

namespace {

// "line: reason" of each production that does not rewrite the modules of a step, modules with | between them.
std::string refused(std::string_view text, std::uint32_t step, std::optional<std::uint32_t> steps = 3,
                    const lsystem::DerivationOptions& options = {}) {
  std::string all;
  const BoundPointer bound = compiled(text);
  const DerivationTrace trace = traced(*bound, steps, {.step = step}, options);
  for (const TraceEntry& module : trace.modules()) {
    if (!all.empty()) all += " | ";
    all += module.text;
    for (const lsystem::Refusal& refusal : module.refusals)
      all += " " + std::to_string(refusal.production.line) + ": " + english(refusal.reason) + ";";
  }
  return all;
}

}  // namespace

TEST_CASE("the trace of a module lists the reasons why other productions of its symbol do not rewrite it") {
  CHECK(refused("axiom: A(3) F\nA --> F\nA(x) : x>4 && x<9 --> F\nA(x) : x>2 --> F\nA(x) --> F", 0) ==
        "A(3) 2: the production expects no parameters, but the module has 1 parameter; 3: the condition is false with "
        "x = 3; "
        "5: the production on line 4 takes precedence; | F");
  // The last string has reasons too, but none for the production that would rewrite it.
  CHECK(refused("axiom: A(3)\nA(x) --> A(x+1)\nA(x) : x>9 --> B", 2, 2) ==
        "A(5) 3: the condition is false with x = 5;");
  CHECK(refused("axiom: A(1)\nA(x) : x<3 --> A(x+1)", 2, {}) == "A(3) 2: the condition is false with x = 3;");
  // Conditions are those of the module with its answer.
  Adding adding;
  const lsystem::DerivationOptions options{{}, nullptr, &adding};
  CHECK(refused("#turtle cpfg\naxiom: ?E(2,1)\n?E(r,n) : n>4 --> F\n?E(r,n) : n=3 --> ?E(r,n)", 0, 2, options) ==
        "?E(2,1) 3: the condition is false with r = 2, n = 3;");
}

TEST_CASE("the reason for a context that does not match names the neighbours, and a bracket between them") {
  CHECK(refused("axiom: B A C\nF < A --> F\nA > F --> F\nB < A > F --> F\nB < A > C F --> F", 0)
            .find("A 2: the symbol before the module is “B”, not “F”; 3: the symbol after the module is “C”, not “F”; "
                  "4: the symbol after the module is “C”, not “F”; 5: the context does not match;") !=
        std::string::npos);
  CHECK(refused("axiom: A\nF < A --> F\nA > F --> F", 0) ==
        "A 2: there is no module before this one, but “F” is required; "
        "3: there is no module after this one, but “F” is required;");
  CHECK(refused("axiom: [ B ] A [ + C ] [ C ]\nB < A --> F\nA > C --> F", 0)
            .find("A 2: the “B” before the module is in a closed branch, where a left context does not match; "
                  "3: the “C” after the module is in a branch; to match it there, write “> [ C ]”;") !=
        std::string::npos);
  CHECK(refused("axiom: B(1) A C(1)\nB(x,y) < A --> F\nA > C --> F", 0)
            .find("A 2: the “B” before the module has 1 parameter, not 2 parameters; "
                  "3: the “C” after the module has 1 parameter, not no parameters;") != std::string::npos);
  CHECK(refused("axiom: B(7) A(2)\nB(y) < A(x) : y<x --> F", 0) ==
        "B(7) | A(2) 2: the condition is false with x = 2, y = 7;");
}

TEST_CASE("the reason for a production that was not drawn names the one that the derivation drew") {
  const std::string text = "axiom: A A A A A A\nA --> B : 1\nA --> C : 1\nA : ran(1)<0.5 --> F : 1";
  const BoundPointer bound = compiled(text);
  std::size_t drawn = 0, false_ones = 0;
  const DerivationTrace axiom = traced(*bound, 1, {.step = 0});
  for (const TraceEntry& module : axiom.modules()) {
    REQUIRE(module.refusals.size() == 2);
    for (const lsystem::Refusal& refusal : module.refusals) {
      CHECK(refusal.production.line != module.fires.line);
      drawn += english(refusal.reason) ==
               "the production on line " + std::to_string(module.fires.line) + " was chosen at random";
      false_ones += english(refusal.reason) == "the condition is false";
    }
  }
  CHECK(drawn + false_ones == 12);
  CHECK(drawn > 6);
  CHECK(false_ones > 0);
  // A condition that draws is drawn anew in each step.
  const BoundPointer waits = compiled("axiom: A A A A A A A A\nA : ran(1)<0.3 --> F");
  for (std::uint32_t step = 0; step < 3; ++step) {
    const DerivationTrace trace = traced(*waits, 4, {.step = step});
    for (const TraceEntry& module : trace.modules())
      if (module.text == "A") CHECK(module.refusals.empty() == (module.fires.line > 0));
  }
}
