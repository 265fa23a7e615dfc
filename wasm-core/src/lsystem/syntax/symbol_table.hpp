// The symbols of a text by number: the turtle's, then the text's own, and which of them productions rewrite.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "expression/names.hpp"
#include "lsystem/derivation/program.hpp"
#include "lsystem/syntax/parser.hpp"

namespace panicle::lsystem {

class SymbolTable {
 public:
  // Both must outlive it. `program` gets symbols, meanings and predecessors by `fill`.
  SymbolTable(const Grammar& grammar, Program& program) : grammar_(grammar), program_(program) {}

  void fill();

  // The number of a name, in the L-system of that number (0: the text itself); Names::none where it has none.
  std::uint32_t find(std::string_view name, std::uint32_t system = 0) const;
  // Whether the turtle, the drawing pen, has an action for the symbol.
  bool is_turtles(std::uint32_t symbol) const { return program_.meanings[symbol] != no_meaning; }
  // Whether a production of derivation with so many parameters rewrites the symbol.
  bool is_derived(std::uint32_t symbol, std::size_t arity) const { return (derived_[symbol] >> arity & 1) != 0; }
  // By a production of any purpose.
  bool is_rewritten(std::uint32_t symbol) const { return rewritten_[symbol] != 0; }
  // Whether modules of the symbol need a lineage: those that write others, and those that listeners observe.
  bool remembers(std::uint32_t symbol) const;
  // Whether a name such as `FF` or `AB`, where F, A and B have meanings, has none itself: in cpfg two modules, here one
  // without effect.
  bool stands_for_itself(std::string_view name, std::uint32_t symbol) const;

 private:
  std::uint32_t add(std::string_view name, std::uint32_t system);
  std::uint32_t add(std::string_view full, std::string_view name);
  std::uint8_t meaning_of(std::string_view name) const;
  void add_turtles();
  void add_rewritten(const ProductionTree& production);
  void release_letters();

  const Grammar& grammar_;
  Program& program_;
  Names numbers_;
  // By symbol: a bit for each arity (at most 32) of its productions, those of derivation and all.
  std::vector<std::uint64_t> derived_, rewritten_;
};

}  // namespace panicle::lsystem
