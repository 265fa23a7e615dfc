// What a text says and the engine passes over is told.
#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;
using lsystem::Remark;

namespace {

// "line:column message" of each, with | between them.
std::string remarked(std::string_view text, std::span<const Inputs::Scalar> asked = {},
                     std::optional<std::uint32_t> steps = {}) {
  std::string all;
  for (const Remark& remark : lsystem::remarks(*sound(lsystem::compile(text, Limits{})), asked, steps)) {
    CHECK(remark.message.back() == '.');
    all += (all.empty() ? "" : "|") + std::to_string(remark.line) + ":" + std::to_string(remark.column) + " " +
           remark.message;
  }
  return all;
}

}  // namespace

TEST_CASE("there is nothing to remark on where everything is heeded") {
  for (const char* text : {
           "axiom: A(5)\nA(i) : i>0 --> F(i) [ +(35) A(i-1) ] [ // B ] !(2) S(1)",
           "#define angle 35\naxiom: A\nA --> F [ +(angle) B ] [ + B ] Bud Flower1 G T2",
           "axiom: A\nA -->\n  // Leaf(1)\n  // Leaf Leaf2(1)\n  // A2 B\nA2 --> F",
           "axiom: Fl\nFl --> F Fr\nFr --> f",
           "axiom: F1\nF1 --> F(1)",
           "#role bud A\naxiom: A",
       }) {
    CAPTURE(text);
    CHECK(remarked(text) == "");
  }
}

TEST_CASE("symbols that look like the turtle's and are not its are told once, at their first place") {
  CHECK(remarked("axiom: A\nA --> F1 [ f20 F1 ] S2(3)") ==
        "2:7 F1 is one symbol of its own and draws nothing; write F(1).|"
        "2:12 f20 is one symbol of its own and draws nothing; write f(20).|"
        "2:21 S2 is one symbol of its own and draws nothing; write S(2).");
  CHECK(
      remarked("axiom: G(1) g(2)") ==
      "1:8 G draws nothing in the paper's notation, which this text has; a line #turtle cpfg makes it the turtle's.|"
      "1:13 g draws nothing in the paper's notation, which this text has; a line #turtle cpfg makes it the turtle's.");
}

TEST_CASE("a line that is meant as a comment is told") {
  CHECK(
      remarked("axiom: A\nA --> F\n  // the stem grows\n  A") ==
      "3:3 This line is read as two rolls of the turtle and symbols that draw nothing; a comment is written /* … */.");
  CHECK(remarked("axiom: A // two words") == "");
  CHECK(remarked("axiom: A\n// two A\nA --> F") == "");
}

TEST_CASE("arguments that are left out and not what they are elsewhere") {
  CHECK(remarked("axiom: ! F !(2) !") ==
        "1:8 ! without an argument sets the width to 1; in cpfg it narrows the lines: write !(w).");
  CHECK(remarked("#define angle 25\naxiom: F / F - F + F") ==
        "2:10 / without an argument turns by 90° and does not heed 'angle'; write /(angle), or a line angle increment: "
        "angle.");
  CHECK(remarked("#define angle 25\n#define wide angle*2\naxiom: F + F") == "");
  CHECK(remarked("#define delta 25\naxiom: A\nA : delta>3 --> + F") == "");
}

TEST_CASE("the turtle's sphere as a symbol of one's own") {
  CHECK(remarked("axiom: S\nS --> F S\nS(i) --> F") ==
        "2:1 S is the turtle's sphere and is drawn where no production rewrites it; give a symbol of your own another "
        "name.");
  std::string message;
  CHECK(trouble("axiom: S(1,2)\nS(i,j) --> F", {}, {}, &message) == "syntax 1:8");
  CHECK(message ==
        "'S' (sphere) takes at most one argument, but here it has 2; leave out the rest, or name a symbol of "
        "your own otherwise.");
}

TEST_CASE("a random condition that is tried once is told, unless there are steps") {
  const std::string text = "axiom: A\nB --> F : 2\nA : ran(1)<0.3 --> B";
  CHECK(remarked(text) == "3:1 A draws for its random condition once; with a derivation length it draws in each step.");
  CHECK(remarked(text, {}, 5) == "");
  CHECK(remarked("derivation length: 5\n" + text) == "");
}

TEST_CASE("constants that are asked for and that the text does not know") {
  const Inputs::Scalar asked[] = {{"a", 1}, {"b", 2}, {"c", 3}};
  CHECK(remarked("#define a 1\n#input c\naxiom: A", asked) ==
        "0:0 The grammar has no #define b, so its parameter changes nothing.");
}

TEST_CASE("a remark is written with its place where it has one") {
  CHECK(lsystem::to_text(Remark{"F1 draws nothing.", 3, 7}) == "Line 3, column 7: F1 draws nothing.");
  CHECK(lsystem::to_text(Remark{"No more.", 0, 0}) == "No more.");
}

TEST_CASE("remarks stand in the order of the text") {
  CHECK(remarked("axiom: !\nA --> G(1)\n  F3\nS --> A").find("1:8 !") == 0);
  const std::string all = remarked("axiom: !\nA --> G(1)\n  F3\nS --> A");
  CHECK(all.find("2:7 G") < all.find("3:3 F3"));
  CHECK(all.find("3:3 F3") < all.find("4:1 S"));
  CHECK(remarked("A --> g(1) !\naxiom: ! G(1)\nB --> F3 g(1)") ==
        "1:7 g draws nothing in the paper's notation, which this text has; a line #turtle cpfg makes it the turtle's.|"
        "2:8 ! without an argument sets the width to 1; in cpfg it narrows the lines: write !(w).|"
        "2:10 G draws nothing in the paper's notation, which this text has; a line #turtle cpfg makes it the turtle's.|"
        "3:7 F3 is one symbol of its own and draws nothing; write F(3).");
}
