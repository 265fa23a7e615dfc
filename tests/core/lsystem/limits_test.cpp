// Work that would never end ends in a value, with the count that was reached.
#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

void stops(const std::string& text, const Limits& limits, const char* part, const Inputs& inputs = {}) {
  std::string message;
  const std::string found = trouble(text, inputs, limits, &message);
  CAPTURE(message);
  CHECK(found.substr(0, 5) == "limit");
  CHECK(message.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("a string that doubles endlessly stops at the limit of words") {
  Limits limits;
  limits.words = 100'000;
  stops("axiom: A\nA --> A A", limits, "100000 words");
  stops("axiom: A\nA --> A A", Limits{}, "limit");
}

TEST_CASE("a string of exactly the limit of words is allowed") {
  Limits limits;
  const BoundPointer bound = compiled("axiom: A\nA --> A A");
  for (const std::uint32_t steps : {3u, 10u, 14u}) {
    limits.words = 1u << steps;
    CHECK(lsystem::develop(*bound, 1, steps, limits));
    CHECK_FALSE(lsystem::develop(*bound, 1, steps + 1, limits));
  }
}

TEST_CASE("a derivation that never ends stops at the limit of steps") {
  stops("axiom: A\nA --> A", Limits{}, "4096 steps");
  stops("axiom: A\nA --> B\nB --> A", Limits{}, "4096 steps");
  Limits limits;
  limits.steps = 3;
  stops("axiom: A(4)\nA(i) : i>0 --> F A(i-1)", limits, "3 steps");
  CHECK(trouble("axiom: A(3)\nA(i) : i>0 --> F A(i-1)", {}, limits) == "none");
  const BoundPointer bound = compiled("axiom: A\nA --> A");
  CHECK(derived(*bound, 100).steps == 100);
}

TEST_CASE("productions applied, tried and copied over count as work") {
  Limits limits;
  limits.work = 1000;
  stops("axiom: A\nA --> A A", limits, "limit of 1000 units of computing work");
  std::string many = "axiom: A(1)\n";
  for (int i = 0; i < 2000; ++i) many += "A(x) : x>2 --> B\n";
  stops(many, limits, "limit of 1000 units of computing work");
  std::string long_string = "axiom: A ";
  for (int i = 0; i < 3200; ++i) long_string += "F ";
  stops(long_string + "\nA --> A", limits, "limit of 1000 units of computing work");
  std::string long_expression = "axiom: A(1)\nA(x) --> A(x";
  for (int i = 0; i < 3200; ++i) long_expression += "+x*" + std::to_string(i);
  stops(long_expression + ")", limits, "limit of 1000 units of computing work");
}

TEST_CASE("texts, nesting and parameters have limits too") {
  Limits limits;
  limits.text_bytes = 10;
  stops("axiom: A(1)", limits, "the limit is 10");
  const std::string open(100'000, '('), close(100'000, ')');
  stops("axiom: A(" + open + "1" + close + ")", Limits{}, "nested more than 256 levels deep");
  stops("axiom: A(" + std::string(100'000, '-') + "1)", Limits{}, "nested more than 256 levels deep");
  std::string many = "axiom: A(1";
  for (int i = 0; i < 40; ++i) many += ",1";
  stops(many + ")", Limits{}, "32 parameters");
  std::string formals = "axiom: A\nA(x";
  for (int i = 0; i < 40; ++i) formals += ",x" + std::to_string(i);
  stops(formals + ") --> B", Limits{}, "32 parameters");
}

TEST_CASE("long texts are read in proportion to their length") {
  std::string text = "axiom: A(1)\n";
  for (int i = 0; i < 8000; ++i) text += "#define x" + std::to_string(i) + " " + std::to_string(i) + "\n";
  CHECK(trouble(text + "A(x) : x<0 --> B") == "none");
  std::string sum = "axiom: V(1";
  for (int i = 0; i < 60'000; ++i) sum += "+1";
  CHECK(trouble(sum + ")") == "none");
  std::string terms = "axiom: A(1)\nA(x) --> V(1";
  for (int i = 0; i < 20'000; ++i) terms += "+x*" + std::to_string(i);
  CHECK(trouble(terms + ")") == "none");
}

namespace {

// As many repetitions as a text may have, `begin` and `end` included. `%` stands for the number of each.
std::string largest(const std::string& begin, const std::string& repeated, const std::string& end = {}) {
  std::string text = begin;
  for (int i = 0;; ++i) {
    std::string part = repeated;
    for (std::size_t at; (at = part.find('%')) != std::string::npos;) part.replace(at, 1, std::to_string(i));
    if (text.size() + part.size() + end.size() > Limits{}.text_bytes) return text + end;
    text += part;
  }
}

}  // namespace

TEST_CASE("lists of symbols, roles, labels and signs are read in proportion to their length, up to the largest text") {
  const std::string symbols = largest("axiom: ", "a% ").substr(0, 120'000), list = symbols.substr(7);
  CHECK(trouble("ignore: " + list + "\n" + symbols) == "none");
  std::string systems = "axiom: A\n";
  for (int i = 0; i < 5000; ++i) systems += "Lsystem: l" + std::to_string(i) + "\nA --> B\n";
  CHECK(trouble(largest(systems + "endlsystem\nignore: ", "A ")) == "none");
  CHECK(trouble(largest("axiom: A\n", "B% --> B\n#role r% B%\n")) == "none");
  CHECK(trouble(largest("axiom: A\n#define x 1\n", "p% : x --> A\n")) == "none");
  CHECK(trouble(largest("axiom: A\n", "B --> p%\nA% : B --> A\n")) == "syntax 3:1");
  CHECK(trouble(largest("axiom: A\n#define x 1\n", "p% : x --> A p%\n")) == "none");
  CHECK(trouble(largest("axiom: A\n", "'", "")) == "none");
  CHECK(trouble(largest("#define n[] 1", ",1", "\naxiom: F(n[2])")) == "none");
  CHECK(trouble(largest("axiom: A" + std::string(100'000, ' '), "'")) == "none");
}

TEST_CASE("looking up a request's values takes time linear in their number") {
  std::string text = "axiom: A(x7)\n";
  Inputs inputs;
  for (int i = 0; i < 14'000; ++i) text += "#define x" + std::to_string(i) + " 1\n";
  for (int i = 0; i < 100'000; ++i) inputs.scalars.push_back({"x" + std::to_string(100'000 - i), 1.0f * i});
  inputs.scalars.push_back({"x7", 1});  // of two values the first counts
  const BoundPointer bound = compiled(text, inputs);
  CHECK(text_of(*bound, derived(*bound, 0)) == "A(99993)");
  CHECK(lsystem::remarks(lsystem::program_of(*bound), inputs.scalars).size() == 100'000 - 13'999);
}
