#include "expression/dialect_hints.hpp"

#include <span>

#include "expression/messages.generated.hpp"

namespace panicle::expression {
namespace {

using namespace messages::expression;

// A spelling of another program, and advice on it.
struct Entry {
  std::string_view written;
  Hint hint;
};

// The advice on a spelling, or null.
Hint find(std::span<const Entry> entries, std::string_view written) {
  for (const Entry& entry : entries)
    if (entry.written == written) return entry.hint;
  return nullptr;
}

constexpr Entry statements[] = {
    {"derivation", &hint_steps}, {"seed", &hint_seed},   {"Seed", &hint_seed},   {"angle", &hint_angle},
    {"Angle", &hint_angle},      {"delta", &hint_angle}, {"δ", &hint_angle},     {"ω", &hint_axiom},
    {"Ω", &hint_axiom},          {"omega", &hint_axiom}, {"Axiom", &hint_axiom}, {"AXIOM", &hint_axiom},
};

constexpr Entry labels[] = {{"iterations", &hint_steps}, {"iteration", &hint_steps}, {"generations", &hint_steps},
                            {"depth", &hint_steps},      {"steps", &hint_steps},     {"n", &hint_steps},
                            {"N", &hint_steps}};

constexpr Entry directives[] = {{"ignore", &hint_ignore}, {"consider", &hint_consider}, {"include", &hint_include}};

constexpr Entry signs[] = {{"_", &hint_width}, {"°", &hint_degrees}};

constexpr Entry modules[] = {{"=", &hint_arrow}, {"*", &hint_star}};

constexpr Entry operators[] = {{"?", &hint_choice}, {"&", &hint_and}, {"|", &hint_or},      {"!", &hint_not_equal},
                               {"and", &hint_and},  {"or", &hint_or}, {"(", &hint_operator}};

constexpr Entry called[] = {{"not", &hint_not},    {"rand", &hint_random}, {"random", &hint_random},
                            {"rnd", &hint_random}, {"Math", &hint_random}, {"if", &hint_if}};

}  // namespace

// Advice on statements, labels, signs … that other programs for L-systems have; null if there is none.
Hint foreign_statement(std::string_view first_word) { return find(statements, first_word); }
// The message for a word, sign or module that is none of this notation, but of a known other one; none for unknown
// ones.
Hint foreign_label(std::string_view first_word) { return find(labels, first_word); }
Hint foreign_directive(std::string_view word) { return find(directives, word); }
Hint foreign_sign(std::string_view character) { return find(signs, character); }
Hint foreign_module(std::string_view token) { return find(modules, token); }
Hint foreign_function(std::string_view name) { return find(called, name); }
Hint foreign_operator(std::string_view token) { return find(operators, token); }

}  // namespace panicle::expression
