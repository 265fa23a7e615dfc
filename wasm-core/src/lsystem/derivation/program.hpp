// A compiled grammar: symbols, productions with their successors as words, and byte code. Values that depend on the
// inputs are added by BoundProgram (bound_program.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "expression/code.hpp"
#include "lsystem/derivation/words.hpp"
#include "lsystem/lsystem.hpp"
#include "lsystem/syntax/grammar.hpp"
#include "lsystem/turtle/turtle_symbols.generated.hpp"

namespace panicle::lsystem {

// Symbols are numbered: the turtle's as in turtle_symbols, then the text's own in the order of appearance. The turtle
// command of a symbol is in Program::meanings.
inline constexpr std::uint8_t no_meaning = 0xff;
static_assert(turtle_symbols.size() < no_meaning);

// The number of the turtle's symbol for an action.
constexpr std::uint32_t symbol_for(Action action) {
  std::uint32_t symbol = 0;
  while (turtle_symbols[symbol].action != action) ++symbol;
  return symbol;
}
inline constexpr std::uint32_t push_symbol = symbol_for(Action::push);
inline constexpr std::uint32_t pop_symbol = symbol_for(Action::pop);
inline constexpr std::uint32_t cut_symbol = symbol_for(Action::cut);
inline constexpr std::uint32_t query_symbol = symbol_for(Action::query);

// The values that a parameter may have: the turtle takes finite numbers only.
enum class Demand : std::uint8_t { none, finite, not_negative };

// A successor (or the axiom): words to copy, and patches for parameters that depend on the rewritten module.
struct Template {
  std::uint32_t first = 0;  // in BoundProgram::words; room for a copy in whole blocks follows
  std::uint32_t words = 0;
  std::uint32_t modules = 0;
  std::uint32_t cost = 0;  // units of work that writing it takes
  Range code;
  Range patches;  // parameters that the module which is rewritten decides
  Range births;   // lineages
  Range active;   // modules that the next step has to look at
};

struct Patch {
  std::uint32_t offset = 0;   // in its template; in Program::words where the inputs decide
  std::uint32_t precise = 0;  // likewise of the parameter as a double, where modules have some
  std::uint32_t source = 0;   // register
  Demand demand = Demand::none;
  std::uint32_t symbol = 0;
  SourceLocation place;
};

struct Birth {
  std::uint32_t offset = 0;
  std::uint64_t key = 0;  // the module's place in the successor: its symbol, and how many of them stand before it
};

// A module of a production's context, or a bracket of a branch in it.
struct Neighbour {
  static constexpr std::uint32_t any = 0xffffffff;
  // The part of a header that contexts compare: symbol, number of parameters, and precision.
  static constexpr std::uint32_t kind(std::uint32_t header) { return header & 0xffffff; }

  std::uint32_t symbol = 0;
  std::uint32_t arity = 0;
  std::uint32_t to = 0;      // register of its first parameter
  std::uint32_t closed = 0;  // of an opening bracket: the place of the one that closes it
};

struct Production {
  std::uint32_t predecessor = 0;
  SourceLocation place;
  std::uint32_t arity = 0;
  Value condition;
  Value weight;
  bool by_chance = false;   // whether its condition or weight draws
  bool in_context = false;  // whether it wants neighbours
  bool looks_on = false;    // whether its context has more than the two adjacent modules
  // The adjacent modules of its context, as Neighbour::kind.
  std::uint32_t nearest_left = Neighbour::any, nearest_right = Neighbour::any;
  Range left;  // neighbours, from the root on
  Range right;
  std::uint32_t cost = 0;  // units of work that trying it takes
  Template successor;
};

// A named value that a production is applied with: a formal parameter, or an assignment of a block.
struct Naming {
  std::string name;
  std::uint32_t source = 0;  // register
};

// The productions of one symbol, in the order of the text.
struct Rules {
  Range productions;
  bool weighted = false;
  bool by_chance = false;   // whether any is weighted or draws in its condition
  bool in_context = false;  // whether any wants neighbours
};

// A `#define` or `#input` of the text.
struct Declaration {
  std::string name;
  Definition::Kind kind = Definition::Kind::define;
  SourceLocation place;
  std::vector<Value> values;  // of a #define; none where they have to be given
  std::uint32_t to = 0;       // register, or place of an array among Code::arrays
};

class Program {
 public:
  // The turtle's action for a symbol; null if it has none.
  const TurtleSymbol* turtle(std::uint32_t symbol) const {
    return meanings[symbol] == no_meaning ? nullptr : &turtle_symbols[meanings[symbol]];
  }
  // Whether it is ?P, ?H, ?L or ?U, whose parameters change from step to step.
  bool is_turtle_query(std::uint32_t symbol) const {
    return meanings[symbol] != no_meaning && turtle_symbols[meanings[symbol]].action >= Action::query_position;
  }
  // Whether there are rules for a purpose (derivation, interpretation …).
  bool has(Purpose purpose) const { return !rules_for[static_cast<std::size_t>(purpose)].empty(); }
  const std::vector<Rules>& rules_of(Purpose purpose) const { return rules_for[static_cast<std::size_t>(purpose)]; }
  // Whether a step depends on more than each module by itself, so that the order of rewriting matters.
  bool by_steps() const { return in_context || locates || has(Purpose::decomposition); }

  Notation notation = Notation::huang;
  std::vector<std::string> symbols;
  std::vector<std::uint8_t> meanings;                  // by symbol: a place in turtle_symbols, or no_meaning
  std::vector<Production> productions;                 // by purpose, then by predecessor, then in the order of the text
  std::vector<Rules> rules;                            // of derivation, by symbol
  std::array<std::vector<Rules>, purposes> rules_for;  // of the others, by symbol; empty where there are none
  std::array<Value, 2> depths;                         // of decomposition and homomorphism
  std::array<Value, settings_count> settings;          // by GlobalSetting
  bool has_queries = false;                            // whether a module queries the environment
  bool locates = false;                                // whether a module queries the turtle's position or axes
  std::vector<std::uint32_t> predecessors;             // in the order of the text
  std::vector<std::uint32_t> words;
  std::vector<Patch> patches;
  std::vector<Patch> bound_patches;  // parameters that the inputs decide, in the order of the text
  std::vector<Birth> births;
  std::vector<Neighbour> neighbours;
  std::vector<std::uint8_t> passed_over;  // by symbol: whether contexts do not see it
  bool in_context = false;                // whether any production wants neighbours
  bool looks_right = false;               // whether any wants them behind it
  bool looks_far_left = false;            // whether any wants more than one before it
  std::vector<std::uint32_t> active;      // offsets in a template
  std::uint32_t longest_successor = 0;    // words
  Template axiom;
  bool lineages = false;
  Code code;
  Range once_bound;                       // code that the inputs alone decide
  std::vector<Declaration> declarations;  // in the order of the text
  std::vector<Naming> namings;
  std::vector<Range> named_in;  // by production: its namings
  Value steps;                  // the derivation length
  Roles roles;
  std::vector<Remark> remarks;  // on the text alone
  Diagnostic not_drawable;      // the first module in an answer that the turtle cannot draw in place
};

}  // namespace panicle::lsystem
