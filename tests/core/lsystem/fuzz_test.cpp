// Texts put together from tokens at random, and good texts with tokens changed: each ends in a value or a diagnostic,
// whatever it is. Meant for the sanitizers; the seeds are fixed, so a failure comes again.
#include <algorithm>

#include "foundation/random.hpp"
#include "lsystem/derivation.hpp"
#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

const std::vector<std::string> pool = {"A",
                                       "B",
                                       "C",
                                       "F",
                                       "f",
                                       "S",
                                       "?E",
                                       "E",
                                       "n",
                                       "m",
                                       "x",
                                       "i",
                                       "l_1",
                                       "α",
                                       "+",
                                       "-",
                                       "*",
                                       "/",
                                       "^",
                                       "%",
                                       "&",
                                       "&&",
                                       "|",
                                       "||",
                                       "\\",
                                       "!",
                                       "!=",
                                       "=",
                                       "==",
                                       "<",
                                       "<=",
                                       ">",
                                       "(",
                                       "(",
                                       "(",
                                       ")",
                                       ")",
                                       ")",
                                       "[",
                                       "[",
                                       "]",
                                       "]",
                                       ",",
                                       ",",
                                       ":",
                                       ":",
                                       "#",
                                       "#define",
                                       "#input",
                                       "\n",
                                       "\n",
                                       "\n",
                                       "axiom:",
                                       "\naxiom: A(1) ",
                                       "-->",
                                       "\nA(x) --> ",
                                       "\nB(x,i) : ",
                                       "\n?E(x) --> ",
                                       "\nA(x) < B(i) > ",
                                       "\nB > [A] C --> ",
                                       "\nignore: + F",
                                       "\nconsider: A",
                                       " --> F(x) ",
                                       "0",
                                       "1",
                                       "2.5",
                                       "1e30",
                                       "1e-9",
                                       "RND(1,3)",
                                       "ran(x)",
                                       "nran(0,1)",
                                       "sin",
                                       "pow",
                                       "min(",
                                       "clamp(x,1,2)",
                                       "n[1]",
                                       "n[x]",
                                       "/*",
                                       "*/",
                                       "/* c */",
                                       "?",
                                       ".",
                                       "$",
                                       "→",
                                       "\xff",
                                       " ",
                                       "\t",
                                       "\r\n",
                                       "endlsystem",
                                       "derivation length:",
                                       "#role ",
                                       "\n#role r A B\n",
                                       "p1:",
                                       "{",
                                       "T(1)",
                                       "\nderivation length: 3\n",
                                       "ran(1)<0.5",
                                       "\n?E(x) : x>0 --> A(x) ?E(x) "};

const std::vector<std::string> good = {
    "#input m\n#input n[]\n#define k 2\naxiom: A(m, 1) ?E(0, 1)\nA(i,x) : i>1 --> F(x) [ // A(i-1, x/k) ] [ +(45) "
    "B(n[i-1], x) "
    "] : 2\n"
    "A(i,x) : i>1 && x>0 --> ?E(0, x) A(i-1, ran(x)) : 1\nA(i,x) : i=1 --> S(RND(1,3))\nB(i,x) : i>0 --> f(x) % B(i-1, "
    "x)\n"
    "?E(t,x) : t=0 --> +(x) F(x) [ & F % F ]\n?E(t,x) --> %\n",
    "axiom: F-F-F-F\nF --> F-F+F+F F-F-F+F\n",
    "derivation length: m+2\naxiom: A(m) [ ?E(1) B(m,1) ] ?E(0)\n#input m\n?E(x) : x>0 && ran(1)<0.4 --> F(x) [ % A(x) "
    "?E(x) ] B(x,2)\n"
    "?E(x) : x=0 --> ?E(1) %\nA(x) : ran(1)<0.3 --> F [ +(n[x]) A(x) ] : x\nA(x) --> B(x,x) : 1\nB(x,i) : ran(i)<1 --> "
    "?E(x)\n#input n[]\n",
    "ignore: + -\naxiom: A(1) B [ + A(2) C ] B A(3) ?E(0)\nA(x) < B > [C] B --> A(x) [ - B ]\nB < A(y) > ?E(x) : x<y "
    "--> C %\nC > A --> B : 2\nA(i) < C --> A(i) C : ran(i)\n",
    "consider: A B\naxiom: A B C [ A B ] A\nA < B > A --> A F\nA > [ A B ] A --> B\n* < B > * --> B C\n",
    "axiom: A\nA --> A [ + A ] !(2) F(min(3,sqrt(2))) | ^ & \\ B\nB --> *\n"};

// The n-th draw of one text.
class Dice {
 public:
  explicit Dice(std::uint64_t text) : text_(text) {}
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(random_integer(7, text_, drawn_++, 0, static_cast<std::int32_t>(count) - 1));
  }

 private:
  std::uint64_t text_;
  std::uint64_t drawn_ = 0;
};

std::string made_up(Dice& dice) {
  std::string text = dice.below(2) ? "axiom: A(1) B(2,3) " : "";
  for (std::size_t tokens = dice.below(60); tokens-- > 0;) {
    text += pool[dice.below(pool.size())];
    if (dice.below(3) > 0) text += ' ';
  }
  return text;
}

std::string damaged(Dice& dice) {
  std::string text = good[dice.below(good.size())];
  for (std::size_t changes = 1 + dice.below(4); changes-- > 0;) {
    const std::size_t at = dice.below(text.size());
    switch (dice.below(3)) {
      case 0:
        text.erase(at, 1 + dice.below(4));
        break;
      case 1:
        text.insert(at, pool[dice.below(pool.size())]);
        break;
      default:
        text.replace(at, 1, pool[dice.below(pool.size())]);
        break;
    }
  }
  return text;
}

class Contrary : public Listener {
 public:
  void line(std::int32_t, const Turtle&, const Turtle&, const Lineage&) override { ++heard; }
  void sphere(const Turtle&, float, const Lineage&) override { ++heard; }
  void ask(const Turtle&, std::span<float> parameters, const Lineage&) override {
    static const float replies[] = {0, 1, 0, -1, 0, 1 / 0.0f, 0, 0 / 0.0f, 3e38f};
    for (float& parameter : parameters) parameter = replies[heard++ % std::size(replies)];
  }
  void cut(const Turtle&) override { ++heard; }
  std::uint32_t heard = 0;
};

Limits small_limits() {
  Limits limits;
  limits.steps = 30;
  limits.words = 20'000;
  limits.evaluations = 20'000;
  limits.depth = 50;
  return limits;
}

// Steps and answers in turn. Whatever is answered, the string stays whole.
Diagnostic asked_and_answered(const Bound& bound, Contrary& listener, const Limits& limits) {
  lsystem::Derivation derivation(bound, 1, limits);
  while (derivation.steps() < 12 && derivation.ask({}, listener)) {
    derivation.step();
    std::uint64_t modules = 0;
    std::int64_t open = 0;
    const lsystem::String& string = derivation.string();
    for (const std::uint32_t* at = string.begin(); at < string.end(); at += lsystem::words_of(*at)) {
      ++modules;
      open += lsystem::symbol_of(*at) == lsystem::push_symbol;
      open -= lsystem::symbol_of(*at) == lsystem::pop_symbol;
      CHECK(open >= 0);
    }
    CHECK(open == 0);
    CHECK(modules == lsystem::length(string));
  }
  Contrary unasked;
  if (derivation.trouble().reason == Reason::none) lsystem::trace(bound, derivation.string(), {}, unasked, 1, limits);
  return derivation.trouble();
}

bool draws_conditions(const lsystem::Program& program) {
  return std::any_of(program.productions.begin(), program.productions.end(),
                     [](const lsystem::Production& production) { return production.by_chance; });
}

// 0: derived and drawn; 1, 2, 3: what failed. A diagnostic that concerns the text has a place in it.
int tried(const std::string& text, std::uint32_t mood) {
  const Inputs inputs{{{"m", 3}, {"x", 2}}, {{"n", {1, 2, 0}}}};
  const Limits limits = small_limits();
  const auto blamed = [&](const Diagnostic& diagnostic) {
    std::uint32_t lines = 1;
    for (const char c : text) lines += c == '\n';
    CHECK(diagnostic.reason != Reason::none);
    CHECK_FALSE(diagnostic.message.empty());
    CHECK(diagnostic.line <= lines);
    CHECK((diagnostic.line == 0) == (diagnostic.column == 0));
    CHECK(diagnostic.column <= text.size() + 1);
  };
  const auto program = lsystem::compile(text, limits);
  if (!program) return blamed(program.error()), 1;
  const auto bound = lsystem::bind(program.value(), inputs, limits);
  if (!bound) return blamed(bound.error()), 1;
  const auto string = lsystem::develop(*bound.value(), 1, 30, limits);
  if (!string) return blamed(string.error()), 2;
  const auto unfolded = lsystem::unfold(*bound.value(), 1, limits);
  if (!unfolded) blamed(unfolded.error());
  if (unfolded && !draws_conditions(*program.value()))
    CHECK(text_of(*bound.value(), unfolded.value()) == text_of(*bound.value(), string.value()));
  Contrary listener;
  listener.heard = mood;
  const Diagnostic asked = asked_and_answered(*bound.value(), listener, limits);
  if (asked.reason != Reason::none) blamed(asked);
  const auto result = lsystem::interpret(*bound.value(), *string->string, {}, listener, 1, limits);
  if (!result) return blamed(result.error()), 3;
  return 0;
}

}  // namespace

TEST_CASE("no text makes the engine fall over") {
  int outcomes[2][4] = {};
  for (std::uint64_t i = 0; i < 6000; ++i) {
    Dice dice(i);
    const bool whole = i % 2 == 0;
    const std::string text = whole ? made_up(dice) : damaged(dice);
    CAPTURE(text);
    ++outcomes[whole][tried(text, static_cast<std::uint32_t>(i / 2))];
  }
  for (const int* kind : {outcomes[0], outcomes[1]}) {
    CHECK(kind[0] > 20);
    CHECK(kind[1] > 100);
  }
  CHECK(outcomes[0][2] > 10);
  CHECK(outcomes[0][3] > 3);
}
