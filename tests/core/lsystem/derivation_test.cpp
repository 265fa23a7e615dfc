// Derivations whose results are known from The Algorithmic Beauty of Plants (Prusinkiewicz and Lindenmayer 1990).
#include <algorithm>
#include <cmath>

#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

std::size_t count(const std::string& text, char symbol) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), symbol));
}

}  // namespace

TEST_CASE("algae grow by Fibonacci's numbers") {
  const BoundPointer bound = compiled("axiom: A\nA --> A B\nB --> A");
  const std::uint64_t lengths[] = {1, 2, 3, 5, 8, 13, 21, 34, 55, 89};
  std::uint64_t sum = 0;
  for (std::uint32_t step = 0; step < 10; ++step) {
    const Derived result = derived(*bound, step);
    CHECK(length(*result.string) == lengths[step]);
    CHECK(result.steps == step);
    if (step > 0) sum += lengths[step];
    CHECK(result.modules_written == sum);
  }
  CHECK(after("axiom: A\nA --> A B\nB --> A", 4) == "A B A A B A B A");
}

TEST_CASE("anabaena: cells have the published polarities") {
  const char* text = "axiom: Ar\nAr --> Al Br\nAl --> Bl Ar\nBr --> Ar\nBl --> Al";
  CHECK(after(text, 2) == "Bl Ar Ar");
  CHECK(after(text, 4) == "Bl Ar Bl Ar Ar Bl Ar Ar");
}

TEST_CASE("Koch's curves have 4^n, 8^n and 7^n segments") {
  const char* island = "axiom: F-F-F-F\nF --> F-F+F+F F-F-F+F";
  const char* snowflake = "axiom: F\nF --> F+(60)F-(120)F+(60)F";
  const char* gosper = "axiom: Fl\nFl --> Fl+(60)Fr++Fr-Fl--Fl Fl-Fr+\nFr --> -Fl+Fr Fr++Fr+Fl--Fl-Fr";
  for (std::uint32_t n = 0; n < 5; ++n) {
    CHECK(count(after(island, n), 'F') == 4 * std::pow(8, n));
    CHECK(count(after(snowflake, n), 'F') == std::pow(4, n));
    CHECK(count(after(gosper, n), 'F') == std::pow(7, n));
  }
}

TEST_CASE("a parametric string is rewritten by condition") {
  const char* text =
      "axiom: B(2) A(4,4)\n"
      "A(x,y) : y<=3 --> A(x*2, x+y)\n"
      "A(x,y) : y>3  --> B(x) A(x/y, 0)\n"
      "B(x)   : x<1  --> C\n"
      "B(x)   : x>=1 --> B(x-1)";
  CHECK(after(text, 1) == "B(1)B(4)A(1,0)");
  CHECK(after(text, 2) == "B(0)B(3)A(2,1)");
  CHECK(after(text, 3) == "C B(2)A(4,3)");
  CHECK(after(text, 4) == "C B(1)A(8,7)");
}

TEST_CASE("the first of several matching productions is applied") {
  CHECK(after("axiom: A(1) A(2) A(3) A\nA(x) : x>2 --> B\nA(x) : x>1 --> C\nA(x) --> D\nA(x) --> G", 1) == "D C B A");
  CHECK(after("axiom: A(1) A(1,2)\nA(x,y) --> B\nA --> C", 1) == "A(1)B");
  CHECK(after("axiom: A\nA : * --> B", 1) == "B");
  CHECK(after("axiom: A\nA : --> B", 1) == "B");
}

TEST_CASE("a successor may be empty, and the turtle's symbols may be rewritten") {
  CHECK(after("axiom: A B C\nB -->\nC --> *", 1) == "A");
  CHECK(after("axiom: A+-A\n+ --> -\n- --> +(30)", 1) == "A-+(30)A");
  CHECK(after("axiom: F(1) F(2) F\nF(s) : s>1 --> F(s/2) F(s/2)\nF --> f", 1) == "F(1)F(1)F(1)f");
}

TEST_CASE("a statement ends where a line begins another") {
  CHECK(after("axiom: A\n  [ B ]\n\nA --> C\n  [ D(1,\n 2) ]\n\n  E /* A --> X */\nB -->\n  G\n#define x 1", 1) ==
        "C[D(1,2)]E[G]");
}

TEST_CASE("derivation ends when nothing rewrites, and counts the steps it took") {
  const BoundPointer bound = compiled("axiom: A(3)\nA(i) : i>0 --> F A(i-1)");
  const Derived result = derived(*bound, 4096);
  CHECK(result.steps == 3);
  CHECK(result.modules_written == 2 + 3 + 4);
  CHECK(text_of(*bound, result) == "F F F A(0)");
  CHECK(derived(*bound, 2).steps == 2);
  CHECK(derived(*bound, 0).steps == 0);
  CHECK(derived(*compiled("axiom: F"), 4096).steps == 0);
}

TEST_CASE("the cut removes the rest of its branch in the step after it was written") {
  // The example of Prusinkiewicz, James and Měch, Synthetic Topiary (1994), section 3.
  CHECK(after("axiom: a[b%[c d]e[%f]]g[h[%i]j]k", 1) == "a[b]g[h[]j]k");
  CHECK(after("axiom: A B\nA --> a % [c]", 1) == "a%[c]B");
  CHECK(after("axiom: A B\nA --> a % [c]", 2) == "a");
  CHECK(after("axiom: [A B] C\nA --> a %\nC --> G", 2) == "[a]G");
  const BoundPointer bound = compiled("axiom: a[b%[c d]e[%f]]g");
  const Derived result = derived(*bound, 4096);
  CHECK(result.steps == 1);
  CHECK(length(*result.string) == 5);
  CHECK(result.modules_written == 5);
}

TEST_CASE("modules that are cut are not rewritten any more") {
  CHECK(after("axiom: [%A] A\nA --> A A", 2) == "[]A A A A");
  CHECK(trouble("axiom: [% A(0)]\nA(x) --> F(1/x)") == "none");
}

TEST_CASE("definitions and predecessors are listed in the order of the text") {
  const BoundPointer bound = compiled("#define a 2\n#input n[]\n#input m\naxiom: F\nB --> A\nA --> B\nB(x) --> A",
                                      {{{"m", 4}}, {{"n", {7, 8}}}});
  const auto definitions = lsystem::definitions(*bound);
  REQUIRE(definitions.size() == 3);
  CHECK(definitions[0].name == "a");
  CHECK(definitions[1].kind == lsystem::Definition::Kind::array);
  CHECK(definitions[1].values == std::vector<float>{7, 8});
  CHECK(definitions[2].kind == lsystem::Definition::Kind::input);
  CHECK(definitions[2].values == std::vector<float>{4});
  CHECK(lsystem::predecessors(lsystem::program_of(*bound)) == std::vector<std::string_view>{"B", "A"});
  CHECK(lsystem::constant(*bound, "a", 9) == 2);
  CHECK(lsystem::constant(*bound, "m", 9) == 4);
  CHECK(lsystem::constant(*bound, "n", 9) == 9);
  CHECK(lsystem::constant(*bound, "x", 9) == 9);
}

TEST_CASE("strings are the same with and without lineages") {
  const char* text = "axiom: A(1)\nA(s) --> F(s)[+A(s/2)][-A(s/2)]";
  const BoundPointer plain = compiled(text);
  const BoundPointer with_lineages = compiled(text, {}, lsystem::Lineages::always);
  const Derived a = derived(*plain, 12), b = derived(*with_lineages, 12);
  CHECK(length(*a.string) == 8 * 4095 + 1);
  CHECK(a.modules_written == b.modules_written);
  CHECK(text_of(*plain, a) == text_of(*with_lineages, b));
}
