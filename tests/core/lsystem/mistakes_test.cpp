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
    {"axiom: A\nA «::= B", "colon"},
    {"axiom: A\nA «= F B", "-->"},
    {"axiom: A\nA -«.33-> B", " : "},
    {"axiom: A\nA «.33--> B", "colon"},
    {"axiom: A\nA «0.33--> B", "colon"},
    {"axiom: A\nA --> B «0.33", "begins with a letter"},
    // Digits and signs that are no symbols.
    {"axiom: F «1 F 1", "begins with a letter"},
    {"axiom: A\n«0 < A --> B", "begins with a letter"},
    {"axiom: A\n«1 --> A 1", "begins with a letter"},
    {"axiom: F«−F", "-"},
    {"axiom: F\nF --> [«∧F]", "not part of the notation"},
    {"axiom: F\nF --> [«∼leaf(1)]", "not part of the notation"},
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
    {"axiom: A\n«// a comment\nA --> B", "/*"},
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
    {"axiom: A(1)\nA(s) : s>1 «and s<3 --> F", "operator"},
    {"axiom: A(1)\nA(s) : s =«> 1 --> F", "value"},
    {"axiom: A(1)\nA(s) : 1<s«<3 --> F", "&&"},
    {"axiom: A(1)\nA(s) --> F(«rand())", "ran"},
    {"axiom: A(1)\nA(s) --> F(«random(1))", "ran"},
    {"axiom: A(1)\nA(s) --> F(2«s)", "*"},
    {"axiom: A\nB < A «< C --> D", "<"},
};

// The error, or else the remarks: "line:column message", with the place of the first.
std::string told(const std::string& text) {
  using namespace lsystem;
  const Limits limits;
  const auto program = compile(text, limits, Lineages::where_needed, Notation::cpfg);
  const auto at = [](std::uint32_t line, std::uint32_t column, const std::string& message) {
    return std::to_string(line) + ":" + std::to_string(column) + " " + message;
  };
  if (!program) return at(program.error().line, program.error().column, program.error().message);
  const auto bound = bind(program.value(), {}, limits);
  if (!bound) return at(bound.error().line, bound.error().column, bound.error().message);
  std::string all;
  for (const Remark& remark : remarks(*program.value()))
    all += all.empty() ? at(remark.line, remark.column, remark.message) : " " + remark.message;
  return all;
}

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
    const std::string message = told(text);
    INFO(text, "\n", message);
    CHECK(message.substr(0, message.find(' ')) == std::to_string(line) + ":" + std::to_string(column));
    std::istringstream all(mistake.advice);
    for (std::string part; std::getline(all, part, '|');) CHECK(message.find(part) != std::string::npos);
  }
}
