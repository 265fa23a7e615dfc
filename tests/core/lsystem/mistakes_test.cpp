// What people type when they copy a grammar out of a book or come from another program: each mistake is told at its
// place, in a sentence that says what to write instead.
#include "lsystem/published.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

struct Mistake {
  // « stands before the place that is told.
  const char* text;
  // What the sentence has in it; several between |.
  const char* advice;
};

const Mistake mistakes[] = {
    // Labels, arrows and probabilities, as the book prints them.
    {"axiom: A\n«p1: A --> B", "label"},
    {"axiom: A\n«p1 : A --> B", "label"},
    {"«ω: A\nA --> B", "axiom:"},
    {"«ω : A\nA --> B", "axiom:"},
    {"«w: A\nA --> B", "axiom:"},
    {"«Axiom: A\nA --> B", "axiom:"},
    {"«axiom A\nA --> B", "axiom:"},
    {"«start: A\nA --> B", "axiom:"},
    {"axiom: A\nA «-> B", "-->"},
    {"axiom: A\nA «→ B", "-->"},
    {"axiom: A\nA «=> B", "-->"},
    {"axiom: A\nA «::= B", "-->"},
    {"axiom: A\nA «= F B", "-->"},
    {"axiom: A\nA -«.33-> B", " : "},
    {"axiom: A\nA «.33--> B", " : "},
    {"axiom: A\nA «0.33--> B", " : "},
    {"axiom: A\nA --> B «0.33", "digit"},
    // Digits and signs that are no symbols.
    {"axiom: F «1 F 1", "digit"},
    {"axiom: A\n«0 < A --> B", "digit"},
    {"axiom: A\n«1 --> A 1", "digit"},
    {"axiom: F«−F", "-"},
    {"axiom: F\nF --> [«∧F]", "^"},
    {"axiom: F\nF --> [«∼leaf(1)]", "~"},
    {"axiom: F\nF --> [«’F]", "'"},
    {"axiom: A\nA --> F «= B", "="},
    // Lines of other programs.
    {"«n = 5\naxiom: A\nA --> B", "derivation length:"},
    {"«iterations: 5\naxiom: A\nA --> B", "derivation length:"},
    {"«derivation length 5\naxiom: A\nA --> B", "derivation length:"},
    {"«δ = 90\naxiom: A\nA --> B", "angle increment:"},
    {"«angle: 25.7\naxiom: A\nA --> B", "angle increment:"},
    {"#«ignore +-F\naxiom: A\nA --> B", "ignore:"},
    {"#«include H\naxiom: A\nA --> B", "include"},
    {"#define R «= 1.456\naxiom: A\nA --> B", "="},
    {"#define R «: 1.456\naxiom: A\nA --> B", ":"},
    {"#define R 1\n#define «R 2\naxiom: A\nA --> B", "R"},
    {"#define R«\naxiom: A\nA --> B", "value"},
    {"axiom: A\n#« a comment\nA --> B", "/*"},
    {"axiom: A\nA --> B «# a comment", "/*"},
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
    {"axiom: A(1)\nA(s) : s>1 «and s<3 --> F", "&&"},
    {"axiom: A(1)\nA(s) : s «=> 1 --> F", ">="},
    {"axiom: A(1)\nA(s) : 1<s«<3 --> F", "&&"},
    {"axiom: A(1)\nA(s) --> F(«rand())", "ran("},
    {"axiom: A(1)\nA(s) --> F(«random(1))", "ran("},
    {"axiom: A(1)\nA(s) --> F(2«s)", "*"},
    {"axiom: A(1)\nA(s) --> F(s)«, A(s)", ","},
    {"axiom: A\nB < A «< C --> D", "<"},
};

}  // namespace

TEST_CASE("mistakes that people make are told at their place, with what to write instead") {
  for (const Mistake& mistake : mistakes) {
    std::string text = mistake.text;
    const std::size_t at = text.find("«");
    text.erase(at, std::string_view("«").size());
    std::uint32_t line = 1, column = 1;
    for (std::size_t i = 0; i < at; ++i) {
      column = text[i] == '\n' ? 1 : column + ((text[i] & 0xc0) != 0x80);
      line += text[i] == '\n';
    }
    std::string message;
    const std::string told = trouble(text, {}, {}, &message);
    INFO(text, "\n", told, " ", message);
    CHECK(told.substr(told.find(' ') + 1) == std::to_string(line) + ":" + std::to_string(column));
    std::istringstream all(mistake.advice);
    for (std::string part; std::getline(all, part, '|');) CHECK(message.find(part) != std::string::npos);
  }
}
