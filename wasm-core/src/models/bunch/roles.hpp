// The kind that a symbol of the text draws: declared by roles, never guessed from its name.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lsystem/lsystem.hpp"
#include "models/bunch/skeleton.hpp"

namespace panicle::bunch {

class SymbolRoles {
 public:
  // `kinds`: of each symbol, by its number.
  explicit SymbolRoles(std::vector<Kind> kinds) : kinds_(std::move(kinds)) {}
  SymbolRoles() = default;

  // The kind of the lines that a production of `symbol` draws, or queries; axis where no role names it, as of the axiom
  // (lsystem::no_symbol).
  Kind of(std::uint32_t symbol) const { return symbol < kinds_.size() ? kinds_[symbol] : Kind::axis; }

 private:
  std::vector<Kind> kinds_;
};

// The roles that a text declares, if any; else those of texts older than such declarations (parameters/bunch.json). A
// role that a bunch does not have gets a note in `notes`.
SymbolRoles roles_of(const lsystem::Program& text, std::vector<std::string>& notes);

}  // namespace panicle::bunch
