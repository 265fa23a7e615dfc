#include "models/bunch/roles.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "models/bunch/parameters.generated.hpp"

namespace panicle::bunch {
namespace {

constexpr std::array<std::string_view, 4> names = {"rachis", "axis", "end", "pedicel"};  // in the order of Kind

std::optional<Kind> kind_named(std::string_view role) {
  const auto found = std::find(names.begin(), names.end(), role);
  if (found == names.end()) return std::nullopt;
  return static_cast<Kind>(found - names.begin());
}

Kind standard_kind(std::string_view symbol) {
  for (const RoleInfo& info : role_table) {
    const bool claims = info.begins ? symbol.substr(0, info.symbol.size()) == info.symbol : symbol == info.symbol;
    if (claims) return kind_named(info.role).value_or(Kind::axis);
  }
  return Kind::axis;
}

}  // namespace

Roles::Roles(std::span<const Declaration> declared, std::vector<std::string>& notes) : declared_(!declared.empty()) {
  std::vector<std::string_view> told;
  for (const Declaration& one : declared) {
    if (const std::optional<Kind> kind = kind_named(one.role)) {
      claims_.push_back({std::string(one.symbol), *kind});
    } else if (std::find(told.begin(), told.end(), one.role) == told.end()) {
      told.push_back(one.role);
      notes.push_back("A bunch has no role " + std::string(one.role) +
                      "; its roles are rachis, axis, end and pedicel.");
    }
  }
}

Kind Roles::of(std::string_view symbol) const {
  if (!declared_) return standard_kind(symbol);
  const auto claim =
      std::find_if(claims_.begin(), claims_.end(), [symbol](const Claim& one) { return one.symbol == symbol; });
  return claim == claims_.end() ? Kind::axis : claim->kind;
}

Roles roles_of(const lsystem::Program& text, std::vector<std::string>& notes) {
  const lsystem::Roles& roles = lsystem::roles(text);
  const std::span<const std::string> symbols = lsystem::symbols(text);
  std::vector<Roles::Declaration> declared;
  for (std::uint32_t symbol = 0; symbol < symbols.size(); ++symbol)
    if (const std::uint32_t role = roles.of(symbol); role != lsystem::Roles::none)
      declared.push_back({roles.names[role], symbols[symbol]});
  return {declared, notes};
}

}  // namespace panicle::bunch
