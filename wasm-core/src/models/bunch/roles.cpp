#include "models/bunch/roles.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "models/bunch/messages.generated.hpp"
#include "models/bunch/parameters.generated.hpp"

namespace panicle::bunch {
namespace {

constexpr std::array<std::string_view, 4> names = {"rachis", "axis", "end", "pedicel"};  // in the order of Kind

// The kind of internode that a role's name means; none for an unknown name.
std::optional<Kind> kind_named(std::string_view role) {
  const auto found = std::find(names.begin(), names.end(), role);
  if (found == names.end()) return std::nullopt;
  return static_cast<Kind>(found - names.begin());
}

// The kind of internodes that a symbol of the paper's texts draws.
Kind standard_kind(std::string_view symbol) {
  for (const RoleInfo& info : role_table) {
    const bool claims = info.begins ? symbol.substr(0, info.symbol.size()) == info.symbol : symbol == info.symbol;
    if (claims) return kind_named(info.role).value_or(Kind::axis);
  }
  return Kind::axis;
}

// Per symbol, the kind that the text declares for it; a note for each unknown role.
std::vector<Kind> declared_kinds(const lsystem::Roles& roles, std::size_t symbols, std::vector<std::string>& notes) {
  std::vector<Kind> kinds(symbols, Kind::axis);
  std::vector<std::uint8_t> reported(roles.names.size(), 0);
  for (std::uint32_t symbol = 0; symbol < symbols; ++symbol) {
    const std::uint32_t role = roles.of(symbol);
    if (role == lsystem::Roles::none) continue;
    if (const std::optional<Kind> kind = kind_named(roles.names[role])) {
      kinds[symbol] = *kind;
    } else if (!reported[role]) {
      reported[role] = 1;
      notes.push_back(message(messages::bunch::role_unknown, roles.names[role]));
    }
  }
  return kinds;
}

}  // namespace

// The kinds of internodes that the symbols of a text draw: as it declares them, or as in the paper if it declares none.
SymbolRoles roles_of(const lsystem::Program& text, std::vector<std::string>& notes) {
  const lsystem::Roles& roles = lsystem::roles(text);
  const std::span<const std::string> symbols = lsystem::symbols(text);
  for (std::uint32_t symbol = 0; symbol < symbols.size(); ++symbol)
    if (roles.of(symbol) != lsystem::Roles::none) return SymbolRoles(declared_kinds(roles, symbols.size(), notes));
  std::vector<Kind> kinds;
  for (const std::string& symbol : symbols) kinds.push_back(standard_kind(symbol));
  return SymbolRoles(std::move(kinds));
}

}  // namespace panicle::bunch
