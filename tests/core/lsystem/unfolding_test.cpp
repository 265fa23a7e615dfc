// Derivation depth first must end where derivation step by step ends.
#include <string>

#include "foundation/english.hpp"
#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

std::string unfolded(const BoundProgram& bound, std::uint64_t seed) {
  return text_of(bound, sound(lsystem::unfold(bound, seed, Limits{})));
}

}  // namespace

TEST_CASE("depth first and step by step end in the same string") {
  for (const char* text : {
           "axiom: F",
           "axiom: A(5)\nA(i) : i>0 --> F(i)[+A(i-1)][-A(i-2)]",
           "axiom: A(4) B(3)\nA(i) : i>0 --> A(i-1) B(i)\nB(i) : i>1 --> [/B(i-1)]\nB(i) : i=1 -->",
           "axiom: A(6)\nA(i) : i>0 --> F(ran(2)) A(i-1) : 2\nA(i) : i>0 --> [A(i-1)] : 1\nA(i) : i>2 --> A(0) A(i-2) "
           ": 1",
           "axiom: a[b%[c d]e[%f]]g[h[%i]j]k",
           "axiom: [A B] C\nA --> a D B\nD --> [E] %\nE --> F(RND(1,9))\nC --> G B",
           "axiom: A(3)\nA(i) : i>0 --> ?E(i,0,0)[A(i-1)]\n?E(a,b,c) --> F(a)",
       }) {
    CAPTURE(text);
    const BoundPointer bound = compiled(text);
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
      CHECK(unfolded(*bound, seed) == text_of(*bound, derived(*bound, 4096, seed)));
  }
}

TEST_CASE("depth first counts the deepest generation and the modules that came out") {
  const auto result = lsystem::unfold(*compiled("axiom: A(3)\nA(i) : i>0 --> F A(i-1)"), 1, Limits{});
  REQUIRE(result);
  CHECK(result->steps == 3);
  CHECK(result->modules_written == 4);
  CHECK(lsystem::length(*result->string) == 4);
}

TEST_CASE("a grammar without an end is an error, when unfolded as well") {
  for (const char* text : {"axiom: A\nA --> A", "axiom: A\nA --> A A", "axiom: A\nA --> F A"}) {
    const auto result = lsystem::unfold(*compiled(text), 1, Limits{});
    REQUIRE(!result);
    CHECK(result.error().reason == Reason::limit);
  }
  Limits little;
  little.words = 100;
  const auto result = lsystem::unfold(*compiled("axiom: A(90)\nA(i) : i>0 --> F A(i-1)"), 1, little);
  REQUIRE(!result);
  CHECK(english(result.error().message).find("100") != std::string::npos);
}
