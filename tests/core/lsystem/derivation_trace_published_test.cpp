// Traces of derivations are consistent, for every published grammar and for random texts: between consecutive steps,
// with the last string, and with the text.
#include "lsystem/derivation/string_text.hpp"
#include "lsystem/derivation_traces.hpp"
#include "lsystem/fuzz.hpp"
#include "lsystem/published.hpp"

using namespace panicle;
using namespace panicle::tests;
using expression::SourceLocation;
using lsystem::DerivationTrace;
using lsystem::ModuleSpan;
using lsystem::TraceEntry;
using lsystem::TraceRequest;

namespace {

// Answers the same question always the same.
class Steady : public Drawn {
 public:
  void query(const Turtle&, std::span<float> parameters, const Lineage&) override {
    for (std::size_t i = 1; i < parameters.size(); ++i) parameters[i] = parameters[0] < 2 ? 1.0f : 0.25f;
  }
};

// A text that is derived, and everything it takes to derive it once more.
struct Grown {
  std::string text;
  BoundPointer bound;
  lsystem::DerivationOptions options;
  Limits limits;
  std::optional<std::uint32_t> steps;

  DerivationTrace trace(const TraceRequest& request) const {
    return sound(lsystem::trace_derivation(*bound, 1, steps, limits, options, request));
  }
  Derived derive() const { return sound(lsystem::develop_so_far(*bound, 1, steps, limits, options)); }
};

// The text from a place on; columns count code points.
std::string_view text_at(std::string_view text, const SourceLocation& place) {
  for (std::uint32_t line = 1; line < place.line; ++line) text = text.substr(text.find('\n') + 1);
  std::uint32_t column = 1;
  std::size_t at = 0;
  for (; column < place.column; ++column) do
      ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80);
  return text.substr(at);
}

std::string symbol_of(const std::string& module) { return module.substr(0, module.find('(')); }

// Whether a traced production begins at its place in the text, with the symbol that it rewrites.
bool stands(const Grown& grown, const SourceLocation& place, const std::string& module) {
  return text_at(grown.text, place).starts_with(symbol_of(module));
}

bool same(const SourceLocation& one, const SourceLocation& other) {
  return one.line == other.line && one.column == other.column;
}

// Children are the modules of the next step that have this parent, and descendants theirs.
void check_module(const Grown& grown, const DerivationTrace& before, const DerivationTrace& after, std::size_t i) {
  const TraceEntry& module = before.modules()[i];
  const ModuleSpan children = module.children;
  std::uint32_t descendants = 0;
  for (std::uint32_t child = children.first; child < children.first + children.count; ++child) {
    if (child - after.first() >= after.modules().size()) return;
    const TraceEntry& entry = after.modules()[child - after.first()];
    CHECK(entry.parent == before.first() + i);
    CHECK(entry.last.first == module.last.first + descendants);
    descendants += entry.last.count;
    CHECK((entry.production.line > 0) == (module.fires.line > 0));
    if (!lsystem::program_of(*grown.bound).has(lsystem::Purpose::decomposition))
      CHECK(same(entry.production, module.fires));
    if (module.fires.line == 0 && module.response.empty()) CHECK(entry.text == module.text);
  }
  CHECK(module.last.count == descendants);
  if (module.fires.line > 0) CHECK(stands(grown, module.fires, module.text));
  if (module.fires.line == 0) CHECK(module.values.empty());
  if (module.fires.line == 0) CHECK(children.count <= 1);
}

// A step and the one after it, from a module on.
void check_steps(const Grown& grown, std::uint32_t step, std::uint32_t first) {
  const DerivationTrace before = grown.trace({.step = step, .first = first, .count = 60});
  if (before.modules().empty()) return;
  const DerivationTrace after =
      grown.trace({.step = step + 1, .first = before.modules()[0].children.first, .count = TraceRequest::most});
  CHECK(before.counts() == after.counts());
  CHECK(after.step() == step + 1);
  std::uint32_t next = before.modules()[0].children.first, last = before.modules()[0].last.first;
  for (std::size_t i = 0; i < before.modules().size(); ++i) {
    const TraceEntry& module = before.modules()[i];
    // One after the other, without a gap.
    CHECK(module.children.first == next);
    CHECK(module.last.first == last);
    next += module.children.count;
    last += module.last.count;
    check_module(grown, before, after, i);
  }
  if (first == 0) CHECK(before.modules()[0].children.first == 0);
  if (first + before.modules().size() == before.counts()[step]) {
    CHECK(next == before.counts()[step + 1]);
    CHECK(last == before.counts().back());
  }
}

// The last string as it is drawn, and the ancestors of some of its modules.
void check_last(const Grown& grown) {
  const Derived derived = grown.derive();
  const auto modules = static_cast<std::uint32_t>(lsystem::length(*derived.string));
  std::vector<std::string> texts;
  for (const std::uint32_t* at = derived.string->begin(); at < derived.string->end(); at += lsystem::words_of(*at))
    texts.push_back(lsystem::module_text(*grown.bound->program, at));
  for (const std::uint32_t first : {0u, modules / 2, modules - std::min(modules, 30u)}) {
    const std::uint32_t module = std::min(modules, first + 7) - 1;
    const DerivationTrace last = grown.trace({.step = 0xffffffff, .first = first, .count = 30, .module = module});
    CHECK(last.counts().back() == modules);
    CHECK(last.modules().size() == std::min(30u, modules - first));
    // Where a limit ends a step, the string has the responses from before it.
    for (std::size_t i = 0; i < last.modules().size(); ++i)
      if (last.modules()[i].response.empty()) CHECK(last.modules()[i].text == texts[first + i]);
    if (modules == 0) return;
    REQUIRE(last.trail().size() == last.counts().size());
    CHECK(last.trail().back() == module);
    const std::uint32_t step = last.step() / 2;
    const DerivationTrace on_the_way = grown.trace({.step = step, .first = last.trail()[step], .count = 1});
    REQUIRE(on_the_way.modules().size() == 1);
    CHECK(on_the_way.modules()[0].last.first <= module);
    CHECK(module - on_the_way.modules()[0].last.first < on_the_way.modules()[0].last.count);
  }
}

void check(const Grown& grown) {
  const DerivationTrace axiom = grown.trace({.count = 1});
  for (const std::uint32_t step : {0u, axiom.steps() / 2, axiom.steps() - std::min(1u, axiom.steps())}) {
    if (step >= axiom.steps()) continue;
    const std::uint32_t count = axiom.counts()[step];
    for (const std::uint32_t first : {0u, count / 3, count - std::min(60u, count)}) {
      CAPTURE(step);
      CAPTURE(first);
      check_steps(grown, step, first);
    }
  }
  check_last(grown);
}

Steady steady;
const Slabs slabs;

Grown published_grown(const std::string& name) {
  Grown grown{published(name), nullptr, {upright, &slabs, nullptr}, {}, {}};
  const Inputs inputs{
      {{"areas", 1}, {"places", 2}, {"forks", 0}},
      {{"path", {0, 1, 0, 0, 2, 0}}, {"size", {1, 1, 1}}, {"next", {2, 3}}, {"fork", {0, 0}}, {"own", {1, 1}}}};
  grown.bound = compiled_published(grown.text, inputs);
  if (lsystem::has_queries(lsystem::program_of(*grown.bound))) grown.options.environment = &steady;
  return grown;
}

// The text with another axiom; empty where its own takes more than a line.
std::string with_axiom(const std::string& text, const std::string& axiom) {
  const std::size_t at = text.find("\naxiom:");
  if (at == std::string::npos) return {};
  const std::size_t end = text.find('\n', at + 1);
  return text.substr(0, at) + "\naxiom: " + axiom + text.substr(end);
}

}  // namespace

TEST_CASE("traces of two steps, the last string and the text agree for every published grammar") {
  const std::vector<std::string> names = published_names();
  REQUIRE(names.size() >= 75);
  for (const std::string& name : names) {
    CAPTURE(name);
    check(published_grown(name));
  }
}

// A module without neighbours, as an axiom: one step rewrites it as traced.
TEST_CASE("a traced production, applied again, writes the traced children") {
  std::size_t applied = 0;
  for (const std::string& name : published_names()) {
    CAPTURE(name);
    const Grown grown = published_grown(name);
    const lsystem::Program& program = lsystem::program_of(*grown.bound);
    if (program.in_context || program.locates || program.lineages || name == "topiary") continue;
    const DerivationTrace axiom = grown.trace({.count = 1});
    const std::uint32_t step = axiom.steps() / 2;
    if (step >= axiom.steps()) continue;
    const DerivationTrace before = grown.trace({.step = step, .first = axiom.counts()[step] / 2, .count = 200});
    const DerivationTrace after = grown.trace({.step = step + 1, .first = before.modules()[0].children.first});
    std::size_t here = 0;
    for (const TraceEntry& module : before.modules()) {
      const std::uint32_t from = module.children.first - after.first();
      if (module.fires.line == 0 || from + module.children.count > after.modules().size() || ++here > 6) continue;
      const std::string text = with_axiom(grown.text, module.text);
      if (text.empty()) continue;
      const BoundPointer alone = compiled_published(text);
      const Derived next = derived(*alone, 1);
      std::string children, anew;
      for (std::uint32_t i = 0; i < module.children.count; ++i) children += after.modules()[from + i].text + " ";
      for (const std::uint32_t* at = next.string->begin(); at < next.string->end(); at += lsystem::words_of(*at))
        anew += lsystem::module_text(*alone->program, at) + " ";
      CHECK(anew == children);
      ++applied;
    }
  }
  CHECK(applied > 100);
}

TEST_CASE("traces of random texts are consistent, or end in a diagnostic") {
  const char* const pieces[] = {"A",         "A(x)",      "B", "F",         "[ A ]",     "[ B F ]",
                                "A(x+1)",    "A(x/2) B",  "%", "?P(0,0,0)", "?E(1,x)",   "?E(x,2)",
                                "B(ran(9))", "[ F % A ]", "",  "F(x)",      "+(x) A(x)", "B [ A(x) ] A"};
  const char* const conditions[] = {"", " : x<4", " : x>=1", " : ran(1)<0.6", " : {y = x*2} y<9 {z = y+1}"};
  const char* const lefts[] = {"A(x)", "A(x)", "B(x)", "B(x)", "A", "B", "?E(x,y)", "B > A(x)", "A(x) < B", "F < A(x)"};
  std::size_t grown_texts = 0, steps = 0;
  const std::uint64_t runs = fuzz_runs(400);
  for (std::uint64_t run = 0; run < runs; ++run) {
    Dice dice(7, 7'000'000 + run);
    std::string text = dice.below(2) == 0 ? "derivation length: 7\n" : "";
    text += "axiom: A(1) [ B ] A ?E(1,1)";
    const auto productions = [&](std::size_t count, bool alone) {
      for (std::size_t i = 0; i < count; ++i) {
        const std::string left = lefts[dice.below(alone ? 4 : std::size(lefts))];
        const bool x = left.find('x') != std::string::npos;
        text += "\n" + left + (x ? conditions[dice.below(std::size(conditions))] : "") + " -->";
        std::string successor;
        for (std::size_t k = dice.below(4); k-- > 0;) {
          const std::string piece = pieces[dice.below(std::size(pieces))];
          if (x || piece.find('x') == std::string::npos) successor += " " + piece;
        }
        text += successor.empty() ? " *" : successor;
        if (dice.below(4) == 0) text += " : 1";
      }
    };
    productions(2 + dice.below(4), false);
    if (dice.below(4) == 0) {
      text += "\ndecomposition\nmaximum depth: 2";
      productions(1 + dice.below(2), true);
    }
    CAPTURE(text);
    const Limits limits = small_limits();
    const auto program = lsystem::compile(text, limits, lsystem::Lineages::where_needed, lsystem::Notation::cpfg);
    if (!program) continue;
    Grown grown{text, sound(lsystem::bind(program.value(), {}, limits)), {{}, nullptr, nullptr}, limits, {}};
    if (dice.below(2) == 0 && lsystem::has_queries(*program.value())) grown.options.environment = &steady;
    const auto derived = lsystem::develop_so_far(*grown.bound, 1, {}, limits, grown.options);
    const auto trace = lsystem::trace_derivation(*grown.bound, 1, {}, limits, grown.options, {});
    if (!derived || !trace) {
      CHECK_FALSE(trace);
      continue;
    }
    // Steps may come to a limit where a derivation at one go does not.
    if (trace->stopped().reason != derived->stopped.reason) continue;
    check(grown);
    ++grown_texts;
    steps += trace->steps();
  }
  CHECK(grown_texts > runs / 4);
  CHECK(steps > runs);
}
