#include "lsystem/syntax/symbol_table.hpp"

namespace panicle::lsystem {

// The turtle is the moving pen that draws a string.

namespace {

constexpr char unreachable[] = "\x1f";  // in a name that no text can have

// Symbols of different L-systems differ even if they have the same name; brackets and other signs of strings are the
// same in all.
std::string full_name(std::string_view name, std::uint32_t system) {
  static constexpr std::string_view everywhere = "[]%{}";
  if (system == 0 || name[0] == '?' || everywhere.find(name) != std::string_view::npos) return std::string(name);
  return std::string(name) + unreachable + std::to_string(system);
}

// The index of a turtle symbol.
std::uint8_t meaning_of_sign(std::string_view sign) {
  std::uint8_t i = 0;
  while (turtle_symbols[i].symbol != sign) ++i;
  return i;
}

}  // namespace

// Numbers all symbols: the turtle's first, then those of the axiom and of the productions in the order of the text.
// Turtle symbols that the text may redefine lose their meaning at the end, when all productions are known.
void SymbolTable::fill() {
  add_turtles();
  for (const ModuleTree& module : grammar_.axiom) add(module.name, module.system);
  for (const ProductionTree& production : grammar_.productions) {
    add_rewritten(production);
    for (const NeighbourTree& neighbour : production.left) add(neighbour.name, production.system);
    for (const NeighbourTree& neighbour : production.right) add(neighbour.name, production.system);
    for (const ModuleTree& module : production.successor) add(module.name, module.system);
  }
  release_letters();
}

// Adds the turtle's symbols; cpfg's own ones are hidden in the other notation.
void SymbolTable::add_turtles() {
  for (std::uint32_t i = 0; i < turtle_symbols.size(); ++i) {
    const TurtleSymbol& turtle = turtle_symbols[i];
    const bool known = !turtle.cpfg_only || grammar_.notation == Notation::cpfg;
    add(known ? std::string(turtle.symbol) : std::string(turtle.symbol) + unreachable, turtle.symbol);
    if (known) program_.meanings.back() = static_cast<std::uint8_t>(i);
  }
}

// Adds the predecessor of a production, and records with how many parameters it is rewritten.
void SymbolTable::add_rewritten(const ProductionTree& production) {
  const std::uint32_t predecessor = add(production.predecessor, production.system);
  const std::uint64_t arity = std::uint64_t{1} << production.arity;
  rewritten_[predecessor] |= arity;
  if (production.purpose != Purpose::derivation) return;
  if (derived_[predecessor] == 0) program_.predecessors.push_back(predecessor);
  derived_[predecessor] |= arity;
}

// Releases the turtle's letters that cpfg lacks to the text, if it rewrites them: they lose their turtle meaning.
void SymbolTable::release_letters() {
  for (std::uint32_t symbol = 0; symbol < program_.symbols.size(); ++symbol) {
    const TurtleSymbol* const turtle = program_.turtle(symbol);
    if (turtle != nullptr && turtle->yields && is_rewritten(symbol) && grammar_.notation == Notation::cpfg)
      program_.meanings[symbol] = no_meaning;
  }
}

// The number of a symbol of an L-system; Names::none if there is none.
std::uint32_t SymbolTable::find(std::string_view name, std::uint32_t system) const {
  return system == 0 ? numbers_.find(name) : numbers_.find(full_name(name, system));
}

std::uint32_t SymbolTable::add(std::string_view name, std::uint32_t system) {
  return system == 0 ? add(name, name) : add(full_name(name, system), name);
}

// Returns the number of a symbol, and adds it where it is new. `full` differs between L-systems, `name` is the symbol
// as the text writes it.
std::uint32_t SymbolTable::add(std::string_view full, std::string_view name) {
  const std::uint32_t number = numbers_.add(full);
  if (number == program_.symbols.size()) {
    program_.symbols.emplace_back(name);
    program_.meanings.push_back(meaning_of(name));
    derived_.push_back(0);
    rewritten_.push_back(0);
  }
  return number;
}

// The turtle command of a symbol that is not the turtle's own: `~leaf`, `?leaf` or F of another L-system.
std::uint8_t SymbolTable::meaning_of(std::string_view name) const {
  if (name[0] == '~') return meaning_of_sign("~");
  if (name[0] == '?' && numbers_.size() > turtle_symbols.size()) return meaning_of_sign("@Di");
  for (std::uint8_t i = 0; i < turtle_symbols.size() && numbers_.size() > turtle_symbols.size(); ++i)
    if (turtle_symbols[i].symbol == name && (!turtle_symbols[i].cpfg_only || grammar_.notation == Notation::cpfg))
      return i;
  return no_meaning;
}

// Whether modules of a symbol carry a lineage: those that are rewritten, drawn, or queries.
bool SymbolTable::remembers(std::uint32_t symbol) const {
  if (is_rewritten(symbol)) return true;
  if (!is_turtles(symbol)) return false;
  switch (program_.turtle(symbol)->action) {
    case Action::line:
    case Action::line_apart:
    case Action::sphere:
    case Action::ball:
    case Action::disc:
    case Action::end_polygon:
    case Action::surface:
    case Action::query:
      return true;
    default:
      return false;
  }
}

// Whether a name is a symbol of its own, and not a word that reads as several known symbols.
bool SymbolTable::stands_for_itself(std::string_view name, std::uint32_t symbol) const {
  if (is_turtles(symbol) || is_rewritten(symbol)) return true;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const std::uint32_t letter = numbers_.find(name.substr(i, 1));
    if (letter == Names::none || !(is_turtles(letter) || is_rewritten(letter))) return true;
  }
  return false;
}

}  // namespace panicle::lsystem
