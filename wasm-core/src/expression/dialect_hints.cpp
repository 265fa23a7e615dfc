#include "expression/dialect_hints.hpp"

#include <span>

namespace panicle::expression {
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

constexpr std::string_view seed = "The seed is given with the request here, not in the text; leave the line out.";
constexpr std::string_view angle = "What turns without an argument turn by is written angle increment: 25 here.";
constexpr std::string_view axiom = "The axiom is written axiom: here.";
constexpr std::string_view wider = "In cpfg this changes the width of lines; here write !(w).";
constexpr std::string_view side_by_side = "Two values stand side by side here; put an operator such as * between them.";

constexpr std::string_view steps = "The number of steps is written in one line here: derivation length: 10.";

constexpr Entry statements[] = {
    {"derivation", steps}, {"seed", seed}, {"Seed", seed}, {"angle", angle}, {"Angle", angle}, {"delta", angle},
    {"δ", angle},          {"ω", axiom},   {"Ω", axiom},   {"omega", axiom}, {"Axiom", axiom}, {"AXIOM", axiom},
};

constexpr Entry labels[] = {{"iterations", steps}, {"iteration", steps}, {"generations", steps},
                            {"depth", steps},      {"steps", steps},     {"n", steps},
                            {"N", steps}};

constexpr Entry directives[] = {
    {"ignore", "What contexts pass over is written ignore: + - F here, without #."},
    {"consider", "What contexts see is written consider: A B here, without #."},
    {"include",
     "There is no #include; put everything into one text, parts of their own as Lsystem: name … endlsystem."},
};

constexpr Entry signs[] = {{"_", wider}, {"°", "Angles are in degrees here; leave the ° out."}};

constexpr Entry modules[] = {
    {"=", "An arrow is written -->; an = stands in a condition or a block, A(x) : x = 1 --> B."},
    {"*",
     "A * alone is an empty successor; in a string of modules it means nothing, and several of a kind are written one "
     "after the other."},
};

constexpr Entry operators[] = {
    {"?", "There is no choice by ?: here; write a production for each case, with its condition."},
    {"&", "And is written && between conditions."},
    {"|", "Or is written || between conditions."},
    {"!", "Not equal is written !=."},
    {"and", "And is written && between conditions."},
    {"or", "Or is written || between conditions."},
    {"(", side_by_side},
};

constexpr std::string_view drawn =
    "A random number from 0 up to 1 is written ran(1), a whole one from a to b RND(a, b).";
constexpr Entry called[] = {
    {"not", "Not is written !: A(x) : !(x > 1) --> B."},
    {"rand", drawn},
    {"random", drawn},
    {"rnd", drawn},
    {"Math", drawn},
    {"if", "There is no if here; write a production for each case, with its condition."},
};

}  // namespace

std::string_view foreign_statement(std::string_view first_word) { return find(statements, first_word); }
std::string_view foreign_label(std::string_view first_word) { return find(labels, first_word); }
std::string_view foreign_directive(std::string_view word) { return find(directives, word); }
std::string_view foreign_sign(std::string_view character) { return find(signs, character); }
std::string_view foreign_module(std::string_view token) { return find(modules, token); }
std::string_view foreign_function(std::string_view name) { return find(called, name); }
std::string_view foreign_operator(std::string_view token) { return find(operators, token); }

}  // namespace panicle::expression
