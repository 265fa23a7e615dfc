// Remarks: parts of a text that the engine ignores are reported.
#include "foundation/english.hpp"
#include "lsystem/grammars.hpp"
#include "lsystem/messages.generated.hpp"

using namespace panicle;
using namespace panicle::tests;
using lsystem::Remark;

namespace {

// "line:column message" of each, with | between them.
std::string remarked(std::string_view text, std::span<const Inputs::Scalar> requested = {},
                     std::optional<std::uint32_t> steps = {}) {
  std::string all;
  for (const Remark& remark : lsystem::remarks(*sound(lsystem::compile(text, Limits{})), requested, steps)) {
    CHECK(english(remark.message.encoded()).back() == '.');
    all += (all.empty() ? "" : "|") + std::to_string(remark.line) + ":" + std::to_string(remark.column) + " " +
           english(remark.message.encoded());
  }
  return all;
}

}  // namespace

TEST_CASE("a text without ignored parts has no remarks") {
  for (const char* text : {
           "axiom: A(5)\nA(i) : i>0 --> F(i) [ +(35) A(i-1) ] [ // B ] !(2) S(1)",
           "#define angle 35\naxiom: A\nA --> F [ +(angle) B ] [ + B ] Bud Flower1 G T2",
           "axiom: A\nA -->\n  // Leaf(1)\n  // Leaf Leaf2(1)\n  // A2 B\nA2 --> F",
           "axiom: Fl\nFl --> F Fr\nFr --> f",
           "axiom: F1\nF1 --> F(1)",
           "#role bud A\naxiom: A",
           // Every number of parameters has its production.
           "axiom: A(1) A(1,2)\nA(x) --> A(x,x)\nA(x,y) --> F(x)",
           "axiom: A\nA --> B(1)\nhomomorphism\nB(x) --> F(x)",
           "axiom: F F(1)\nF(x) --> F",  // the turtle draws the other
           // Conditions that differ in double precision alone.
           "#numbers double\naxiom: A(1)\nA(x) : x<1 --> F\nA(x) : x<1.00000001 --> A(0)",
           // Productions that are drawn by weights, or that match fewer modules, are no duplicates.
           "axiom: A\nA --> B : 0.5\nA --> C : 0.5",
           "axiom: A(1)\nA(x) : x>1 --> B\nA(x) : x>0 --> C\nA(x) --> F",
           "axiom: A(1)\nA(x) : x>1 --> B\nA(y) : y>2 --> C\nA(z) : ran(1)<0.5 --> F\nA(z) : ran(1)<0.5 --> G\n"
           "derivation length: 3",
           "axiom: A B\nB < A --> C\nA > B --> F\nA > B F --> F",
           "derivation length: 2\naxiom: A\nA --> B\ndecomposition\nA --> C\nhomomorphism\nA --> F",
           // Contexts that meet, if only after some steps.
           "axiom: A [ B ] B\nA > B --> C",
           "axiom: A [ B ]\nA > [ B ] --> C",
           "axiom: A [ B ] X\nX --> Y F\nY --> B\nA > B --> C",
           "axiom: X [ B ] B\nX --> F A\nA > B --> C [ F A ]",
           "axiom: A [ + B ] B\nB < A --> C\nA > B --> A",
           "axiom: [ B ] A\nB < A --> C\nB --> B [ A ]",
           "axiom: [ B ] A B X\nB < A --> C\nX --> [ A ]",
           "ignore: F\naxiom: A F [ B ] F B\nA > B --> C",
       }) {
    CAPTURE(text);
    CHECK(remarked(text) == "");
  }
}

TEST_CASE("symbols that look like the turtle's get one remark, at their first place") {
  CHECK(remarked("axiom: A\nA --> F1 [ f20 F1 ] S2(3)") ==
        "2:7 “F1” is read as a single symbol, which draws nothing; write “F(1)”.|"
        "2:12 “f20” is read as a single symbol, which draws nothing; write “f(20)”.|"
        "2:21 “S2” is read as a single symbol, which draws nothing; write “S(2)”.");
  CHECK(remarked("axiom: G(1) g(2)") ==
        "1:8 “G” draws nothing in the notation of this grammar; add the line “#turtle cpfg” to make it a turtle "
        "command.|"
        "1:13 “g” draws nothing in the notation of this grammar; add the line “#turtle cpfg” to make it a turtle "
        "command.");
}

TEST_CASE("a line that looks like a comment gets a remark") {
  CHECK(remarked("axiom: A\nA --> F\n  // the stem grows\n  A") ==
        "3:3 “//” does not begin a comment: this line turns the turtle twice and draws nothing. "
        "Write a comment as “/* … */”.");
  CHECK(remarked("axiom: A // two words") == "");
  CHECK(remarked("axiom: A\n// two A\nA --> F") == "");
}

TEST_CASE("omitted arguments with other defaults than cpfg's get a remark") {
  CHECK(remarked("axiom: ! F !(2) !") ==
        "1:8 “!” without an argument sets the line width to 1, but in cpfg it makes lines narrower. Write “!(width)”.");
  CHECK(remarked("#define angle 25\naxiom: F / F - F + F") ==
        "2:10 “/” without an argument turns by 90° and does not use “angle”; write “/(angle)”, or add the line "
        "“angle increment: angle”.");
  CHECK(remarked("#define angle 25\n#define wide angle*2\naxiom: F + F") == "");
  CHECK(remarked("#define delta 25\naxiom: A\nA : delta>3 --> + F") == "");
}

TEST_CASE("S as a symbol of the text gets a remark") {
  CHECK(remarked("axiom: S(1) S\nS --> F S\nS(i) --> F") ==
        "2:1 “S” draws a sphere wherever no production rewrites it; if you meant a symbol of your own, rename it.");
  std::string message;
  CHECK(trouble("axiom: S(1,2)\nS(i,j) --> F", {}, {}, &message) == "syntax 1:8");
  CHECK(message ==
        "The turtle command “S” takes at most 1 argument, but has 2 here; delete the extra arguments, or, if you "
        "meant a symbol of your own, choose another name.");
}

TEST_CASE("a random condition that is drawn once gets a remark, unless there are steps") {
  const std::string text = "axiom: A\nB --> F : 2\nA : ran(1)<0.3 --> B";
  CHECK(remarked(text) ==
        "3:1 The random condition of “A” is evaluated only once; set a derivation length to evaluate it in each step.");
  CHECK(remarked(text, {}, 5) == "");
  CHECK(remarked("derivation length: 5\n" + text) == "");
}

TEST_CASE("requested constants that the text does not know get a remark") {
  const Inputs::Scalar requested[] = {{"a", 1}, {"b", 2}, {"c", 3}};
  CHECK(remarked("#define a 1\n#input c\naxiom: A", requested) ==
        "0:0 The grammar has no “#define b”, so this parameter has no effect.");
}

TEST_CASE("a remark's text begins with its place, if any") {
  CHECK(english(lsystem::to_text(Remark{message(messages::lsystem::remark_words), 3, 7}))
            .find("Line 3, column 7: This line") == 0);
  CHECK(english(lsystem::to_text(Remark{message(messages::lsystem::remark_words), 0, 0})).find("This line") == 0);
}

TEST_CASE("remarks stand in the order of the text") {
  CHECK(remarked("axiom: !\nA --> G(1)\n  F3\nS --> A").find("1:8 “!”") == 0);
  const std::string all = remarked("axiom: !\nA --> G(1)\n  F3\nS --> A");
  CHECK(all.find("2:7 “G”") < all.find("3:3 “F3”"));
  CHECK(all.find("3:3 “F3”") < all.find("4:1 “S”"));
  CHECK(remarked("A --> g(1) !\naxiom: ! G(1)\nB --> F3 g(1)") ==
        "1:7 “g” draws nothing in the notation of this grammar; add the line “#turtle cpfg” to make it a turtle "
        "command.|"
        "2:8 “!” without an argument sets the line width to 1, but in cpfg it makes lines narrower. Write “!(width)”.|"
        "2:10 “G” draws nothing in the notation of this grammar; add the line “#turtle cpfg” to make it a turtle "
        "command.|"
        "3:7 “F3” is read as a single symbol, which draws nothing; write “F(3)”.");
}

TEST_CASE("a module with another number of parameters than its production has gets one remark for each number") {
  CHECK(
      remarked("axiom: A(1,2) A(3,4)\nA(x) --> B A\nB --> F") ==
      "1:8 “A” has 2 parameters here, but its production on line 2 has 1 parameter, so this module is not rewritten; "
      "use the same number of parameters, or add a production for this module.|"
      "2:12 “A” has no parameters here, but its production on line 2 has 1 parameter, so this module is not rewritten; "
      "use the same number of parameters, or add a production for this module.");
  CHECK(remarked("axiom: A\nA --> A\nA(x) --> F") ==
        "3:1 No “A” in this grammar has 1 parameter, so this production is never used; give it as many parameters as "
        "the modules have.");
  // A part's symbols are its own.
  CHECK(remarked("axiom: A [ ?leaf(1) A(2) ]\nA --> F\nLsystem: leaf\nA(x) --> F") == "");
}

TEST_CASE("a production that an earlier one always precedes gets a remark") {
  const auto behind = [](const std::string& place, const std::string& line) {
    return place + " This production is never used, because the production on line " + line +
           " always applies first; move this one up, or give both productions a weight, as in “A --> B : 0.5”.";
  };
  CHECK(remarked("axiom: A\nA --> B\nA --> C") == behind("3:1", "2"));
  CHECK(remarked("axiom: A(1)\nA(x) --> B\nA(x) : x>1 --> C") == behind("3:1", "2"));
  CHECK(remarked("axiom: A B\nA --> B\nA > B --> C") == behind("3:1", "2"));
  CHECK(remarked("axiom: A(1)\nA(x) : x>1 --> B\nA(y) : y>1 --> C\nA(y) : y>1 --> F : 2") ==
        behind("3:1", "2") + "|" + behind("4:1", "2"));
  CHECK(remarked("axiom: A(1) B\nA(x) > B : x>1 --> B\nA(y) > B : y>1 --> C") == behind("3:1", "2"));
  CHECK(remarked("axiom: A(1) B\nA(x) : x>1 --> B\nA(y) > B : y>1 --> C") == behind("3:1", "2"));
  CHECK(remarked("axiom: A\nA --> B : 0.5\nA --> C") == behind("3:1", "2"));
  CHECK(remarked("axiom: A\nA --> B\nA --> C : 0.5\nA --> F : 0.5") == behind("3:1", "2") + "|" + behind("4:1", "2"));
  // One with a weight before both is drawn from, and the last with it.
  CHECK(remarked("axiom: A(1)\nA(x) : x>1 --> F : 1\nA(x) --> C\nA(x) : x>2 --> G : 2") == "");
  CHECK(remarked("#define w 0\naxiom: A\nA --> B : w\nA --> C") == "");
  CHECK(remarked("axiom: A\nhomomorphism\nA --> B\nA --> C") == behind("4:1", "3"));
}

TEST_CASE("a context that a bracket prevents from matching gets a remark") {
  CHECK(remarked("axiom: A [ B ]\nA > B --> C") ==
        "2:5 The only “B” after “A” on line 1 is in a branch, which a right context skips; to match it there, "
        "write “A > [ B ]”.");
  CHECK(remarked("axiom: A F\nA > B --> A\nA --> F A [ B ]") ==
        "2:5 The only “B” after “A” on line 3 is in a branch, which a right context skips; to match it there, "
        "write “A > [ B ]”.");
  CHECK(remarked("axiom: [ B ] A\nB < A --> C") ==
        "2:1 The only “B” before “A” on line 1 is in a branch that is closed between them, so it does not match as a "
        "left context; write “B” before the opening bracket of that branch.");
  // Modules between two others may vanish.
  CHECK(remarked("axiom: A [ B ] X B\nX --> *\nA > B --> C") == "");
}

TEST_CASE("remarks on productions take work in proportion to the text") {
  // Each symbol becomes the next: as many rounds as there are symbols, were they not counted.
  std::string text = "axiom: A0 [ B ]\nA0 > B --> F";
  for (int i = 9000; i-- > 0;) text += "\nA" + std::to_string(i) + " --> A" + std::to_string(i + 1) + " F";
  for (int i = 0; i < 400; ++i) text += "\nA0 > B --> F [ A0 [ B ] ]";
  CHECK_FALSE(lsystem::remarks(*sound(lsystem::compile(text, Limits{}))).empty());
}
