#include "lsystem/foreign.hpp"

#include <span>

namespace panicle::lsystem {
namespace {

struct Entry {
  std::string_view written;
  std::string_view sentence;
};

std::string_view find(std::span<const Entry> entries, std::string_view written) {
  for (const Entry& entry : entries)
    if (entry.written == written) return entry.sentence;
  return {};
}

constexpr std::string_view system_begins =
    "A numbered L-system begins with 'Lsystem:' in cpfg; here a text is one L-system, so leave the line out.";
constexpr std::string_view seed = "The seed is given with the request here, not in the text; leave the line out.";
constexpr std::string_view axiom = "The axiom is written axiom: here.";
constexpr std::string_view polygon =
    "Braces enclose a polygon or statements in cpfg; the notation has neither, so draw with F and S, and work values "
    "out "
    "in the parameters.";
constexpr std::string_view wider = "In cpfg this changes the width of lines; here write !(w).";
constexpr std::string_view place =
    "In cpfg this asks for the turtle's place or axes; here the only communication module is ?E, which the environment "
    "answers.";
constexpr std::string_view side_by_side = "Two values stand side by side here; put an operator such as * between them.";

constexpr Entry statements[] = {
    {"Lsystem", system_begins},
    {"lsystem", system_begins},
    {"endlsystem", "In cpfg 'endlsystem' ends an L-system; here the end of the text does, so leave the line out."},
    {"derivation", "The number of steps is written in one line here: derivation length: 10."},
    {"decomposition",
     "In cpfg productions of a 'decomposition' apply within the step; here each takes a step, so write the parts into "
     "the "
     "successor in place of the whole."},
    {"homomorphism",
     "In cpfg productions of a 'homomorphism' only say how a module is drawn; there are none here, so write what is "
     "drawn "
     "into the successors, beside the module."},
    {"maximum",
     "In cpfg 'maximum depth:' bounds decomposition or homomorphism; there are none here, so leave the line "
     "out."},
    {"seed", seed},
    {"Seed", seed},
    {"ω", axiom},
    {"Ω", axiom},
    {"omega", axiom},
    {"Axiom", axiom},
    {"AXIOM", axiom},
};

constexpr Entry directives[] = {
    {"ignore", "What contexts pass over is written ignore: + - F here, without #."},
    {"consider", "What contexts see is written consider: A B here, without #."},
    {"include", "There is no #include; put everything into one text."},
};

constexpr Entry signs[] = {
    {"$",
     "In cpfg '$' rolls the turtle until its left axis is level; the notation has no such turn, so roll by / or \\ "
     "through an angle of your own."},
    {"{", polygon},
    {"}", polygon},
    {".",
     "In cpfg '.' is a corner of a polygon; the notation has no polygons, so take it out; numbers have a digit "
     "behind their point."},
    {"~", "In cpfg '~' draws a surface; the notation has none, so draw with F and S."},
    {";", "In cpfg ';' changes the colour or ends a statement; the notation has neither, so take it out."},
    {"'", "In cpfg an apostrophe changes the colour; the notation has no colours, so take it out."},
    {"@",
     "In cpfg '@' begins a special command, such as @O for a sphere; here S(r) draws a sphere, and there are no "
     "others."},
    {"_", wider},
};

constexpr Entry modules[] = {
    {",", "In cpfg ',' changes the colour; the notation has no colours, so take it out."},
    {"#", wider},
    {"<", "A left context stands before the predecessor, A < B --> C; in a string < means nothing here."},
    {">", "A right context stands behind the predecessor, A > B --> C; in a string > means nothing here."},
};

constexpr Entry queries[] = {{"P", place}, {"H", place}, {"U", place}, {"L", place}, {"V", place}};

constexpr Entry operators[] = {
    {"?", "There is no choice by ?: here; write a production for each case, with its condition."},
    {"&", "And is written && between conditions."},
    {"|", "Or is written || between conditions."},
    {"!", "Not equal is written !=."},
    {"(", side_by_side},
};

}  // namespace

std::string_view foreign_statement(std::string_view first_word) { return find(statements, first_word); }
std::string_view foreign_directive(std::string_view word) { return find(directives, word); }
std::string_view foreign_sign(std::string_view character) { return find(signs, character); }
std::string_view foreign_module(std::string_view token) { return find(modules, token); }
std::string_view foreign_query(std::string_view name) { return find(queries, name); }
std::string_view foreign_operator(std::string_view token) { return find(operators, token); }

}  // namespace panicle::lsystem
