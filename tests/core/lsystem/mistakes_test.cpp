// Common mistakes when a grammar is copied from a book or another program: each error has the right place and advice.
#include "foundation/english.hpp"
#include "lsystem/published.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

struct Mistake {
  // « marks the expected place of the error.
  const char* text;
  // Parts that the message must contain, separated by |.
  const char* advice;
};

const Mistake mistakes[] = {
    // Labels, arrows and probabilities, as the book prints them.
    {"axiom: A\n«p1: A --> B", "label"},
    {"axiom: A\n«p1 : A --> B", "label"},
    {"«ω: A\nA --> B", "axiom:"},
    {"«ω : A\nA --> B", "axiom:"},
    {"«w: A\nA --> B", "axiom:"},
    {"«axiom A\nA --> B", "axiom:"},
    {"«start: A\nA --> B", "axiom:"},
    {"axiom: A\nA «-> B", "-->"},
    {"axiom: A\nA «→ B", "-->"},
    {"axiom: A\nA «=> B", "-->"},
    {"axiom: A\nA :«:= B", "-->"},
    {"axiom: A\nA «= F B", "-->"},
    {"axiom: A\nA -«.33-> B", " : "},
    {"axiom: A\nA «.33--> B", "colon"},
    {"axiom: A\nA «0.33--> B", "colon"},
    {"axiom: A\nA --> B «0.33", "start with a letter|put a colon before"},
    // Digits and signs that are no symbols.
    {"axiom: F «1 F 1", "start with a letter|“o” and “i” for 0 and 1"},
    {"axiom: A\n«0 < A --> B", "“o” and “i” for 0 and 1"},
    {"axiom: A\n«1 --> A 1", "“o” and “i” for 0 and 1"},
    {"axiom: F«−F", "-"},
    {"axiom: F\nF --> [«∧F]", "“^” in a string"},
    {"axiom: F\nF --> [«∼leaf(1)]", "write “~”"},
    {"axiom: F\nF --> [«’F]", "'"},
    {"axiom: A\nA --> F «= B", "="},
    // Lines of other programs.
    {"«n = 5\naxiom: A\nA --> B", "derivation length:"},
    {"«iterations: 5\naxiom: A\nA --> B", "derivation length:"},
    {"«derivation length 5\naxiom: A\nA --> B", "derivation length:"},
    {"«δ = 90\naxiom: A\nA --> B", "angle increment:"},
    {"«angle: 25.7\naxiom: A\nA --> B", "angle increment:"},
    {"axiom: A\nA --> B\n«iterations: 5", "derivation length:"},
    {"axiom: A\nA --> B\n«n: 3", "derivation length:"},
    {"axiom: A\nA(n) --> B(n)\n«n: 3", "derivation length:"},
    {"axiom: A\nA --> B\n«step: 10", "is not a statement"},
    {"axiom: A\nA --> B\n«my own words: 10", "is not a statement"},
    {"axiom: A\n«angle 60\nA --> B", "angle increment:"},
    {"axiom: A\nA --> F F\n«decomposition warnings", "continues the string above"},
    {"homomorphism: «warnings\naxiom: A\nA --> B", "warnings"},
    {"#input in«(x,y) x\naxiom: A\nA --> B", "is not allowed after the name of an input"},
    {"axiom: A\nA --> B\n«dt = 0.02", "#define dt"},
    {"axiom: A\nA --> B\n«n=5", "derivation length: 10"},
    {"axiom: A\nA --> B\n«ω = 5", "axiom:"},
    {"axiom: A\nA --> +(60«°) B", "delete the “°”"},
    {"axiom: A(2)\nA(x)\n«--> B", "the end of the previous line"},
    {"axiom: A(2)\nA(x) --> C\nA(x) : x>1 {y = 1}\n«--> B", "the end of the previous line"},
    {"axiom: A\nA --> F\nB\n«-> C", "-->"},
    {"axiom: «1\n1 --> 1 0", "write letters, such as “o” and “i”"},
    {"axiom: i\n«1 --> 1 [ 0 ] 0", "write letters, such as “o” and “i”"},
    {"axiom: A\n«p1: A --> B", "delete the label"},
    {"axiom: A\nA(n) «A(m) --> B", "a single module"},
    {"axiom: «?(2,0.5) A", "one word|?leaf(0.5)"},
    {"#«ignore +-F\naxiom: A\nA --> B", "ignore:"},
    {"#«include H\naxiom: A\nA --> B", "include"},
    {"#define R «= 1.456\naxiom: A\nA --> B", "="},
    {"#define R «: 1.456\naxiom: A\nA --> B", ":"},
    {"#define R 1\n#define «R 2\naxiom: A\nA --> B", "R"},
    {"#define R«\naxiom: A\nA --> B", "value"},
    {"axiom: A\n«// a comment\nA --> B", "/*"},
    {"axiom: A\n«# a comment\nA --> B", "/*"},
    // Brackets, parentheses, parameters.
    {"«A --> B", "axiom:"},
    {"axiom: A\nA --> F «[ + A", "[|closed"},
    {"axiom: A\nA --> F «] A", "]"},
    {"axiom: A\nA --> F «(1", "("},
    {"axiom: A(1)\nA(s) --> F(«x)", "x"},
    {"axiom: A(1)\nA(s) : s «≥ 1 --> F", ">="},
    {"axiom: A(1)\nA(s) : s «≤ 1 --> F", "<="},
    {"axiom: A(1)\nA(s) : s «≠ 1 --> F", "!="},
    {"axiom: A(1)\nA(s) : s>1 «& s<3 --> F", "&&"},
    {"axiom: A(1)\nA(s) : s>1 «and s<3 --> F", "“and” between conditions as “&&”"},
    {"axiom: A(1)\nA(s) : s =«> 1 --> F", ">=|<="},
    {"axiom: A(1)\nA(s) : 1<s«<3 --> F", "&&"},
    {"axiom: A(1)\nA(s) --> F(«rand())", "ran(1)"},
    {"axiom: A(1)\nA(s) --> F(«random(1))", "ran(1)"},
    {"axiom: A(1)\nA(s) --> F(2«s)", "*"},
    {"axiom: A(1)\nA(s) : «not(s>1) --> F", "!"},
    {"axiom: A(1)\nA(s) : «0.33 --> F", "meant a weight"},
    {"axiom: «FF", "put spaces between"},
    {"axiom: F\nF --> [+«FFF]F", "put spaces between"},
    {"axiom: A\nA > «?X(x) --> F", "?P"},
    {"axiom: A\nB < A «< C --> D", "<"},
};

// The error, or else the remarks: "line:column message", with the place of the first.
std::string error_of(const std::string& text) {
  using namespace lsystem;
  const Limits limits;
  const auto program = compile(text, limits, Lineages::where_needed, Notation::cpfg);
  const auto at = [](std::uint32_t line, std::uint32_t column, const std::string& message) {
    return std::to_string(line) + ":" + std::to_string(column) + " " + message;
  };
  if (!program) return at(program.error().line, program.error().column, english(program.error().message));
  const auto bound = bind(program.value(), {}, limits);
  if (!bound) return at(bound.error().line, bound.error().column, english(bound.error().message));
  std::string all;
  for (const Remark& remark : remarks(*program.value()))
    all += all.empty() ? at(remark.line, remark.column, english(remark.message.encoded()))
                       : " " + english(remark.message.encoded());
  return all;
}

}  // namespace

TEST_CASE("keywords are recognised in either case, as in cpfg") {
  const std::string text =
      "Angle Increment: 25\nIgnore: F\nDerivation Length: 2\nAxiom: A\nA --> F A\nHomomorphism\nMaximum Depth: 2\nA "
      "--> "
      "f\nEndLsystem";
  CHECK(error_of(text) == "");
}

TEST_CASE("a successor and its weight may continue in the next line") {
  for (const char* text : {"axiom: A\nA -->\nB A : 0.3", "axiom: A\nA --> F\nB: 0.3\nB --> A",
                           "axiom: A B\nA --> F\n  B: 0.3", "axiom: A\nA --> F\nF: 2", "axiom:\nA\nA --> Bud\nBud"})
    CHECK(error_of(text) == "");
}

TEST_CASE("common mistakes are errors at their place, with a replacement") {
  for (const Mistake& mistake : mistakes) {
    std::string text = mistake.text;
    const std::size_t at = text.find("«");
    text.erase(at, std::string_view("«").size());
    std::uint32_t line = 1, column = 1;
    for (std::size_t i = 0; i < at; ++i) {
      column = text[i] == '\n' ? 1 : column + ((text[i] & 0xc0) != 0x80);
      line += text[i] == '\n';
    }
    const std::string message = error_of(text);
    INFO(text, "\n", message);
    CHECK(message.substr(0, message.find(' ')) == std::to_string(line) + ":" + std::to_string(column));
    std::istringstream all(mistake.advice);
    for (std::string part; std::getline(all, part, '|');) CHECK(message.find(part) != std::string::npos);
  }
}
