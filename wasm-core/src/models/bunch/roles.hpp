// What a symbol of the text draws: the roles that a bunch knows, declared and never read out of a name by chance.
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
  // Each symbol's, by its number.
  explicit SymbolRoles(std::vector<Kind> kinds) : kinds_(std::move(kinds)) {}
  SymbolRoles() = default;

  // Of what a production of `symbol` draws, or asks about; axis where no role claims it, as of the axiom
  // (lsystem::no_symbol).
  Kind of(std::uint32_t symbol) const { return symbol < kinds_.size() ? kinds_[symbol] : Kind::axis; }

 private:
  std::vector<Kind> kinds_;
};

// What a text declares, if it declares anything; else those of texts from before there was a way to
// (parameters/bunch.json). A role that a bunch does not have is told in `notes`.
SymbolRoles roles_of(const lsystem::Program& text, std::vector<std::string>& notes);

}  // namespace panicle::bunch
