#include "models/grammar/belonging.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "lsystem/program.hpp"
#include "lsystem/words.hpp"

namespace panicle::grammar {
namespace {

std::uint32_t role_named(const lsystem::Roles& roles, std::string_view name) {
  const auto found = std::find(roles.names.begin(), roles.names.end(), name);
  return found == roles.names.end() ? lsystem::Roles::none : static_cast<std::uint32_t>(found - roles.names.begin());
}

// The number that a module brings; 0 where it is none of an area.
std::uint8_t number_of(const std::uint32_t* module) {
  float number = 0;
  if (lsystem::parameters_of(*module) > 0) std::memcpy(&number, module + 1, sizeof number);
  return number >= 1 && number <= 255 ? static_cast<std::uint8_t>(number) : 0;
}

}  // namespace

std::vector<Belonging> belongings(const lsystem::Program& program, const lsystem::String& string) {
  const lsystem::Roles& roles = lsystem::roles(program);
  const std::uint32_t area_role = role_named(roles, "area"), main_role = role_named(roles, "main");
  if (area_role == lsystem::Roles::none && main_role == lsystem::Roles::none) return {};
  const auto plays = [&](std::uint32_t symbol, std::uint32_t role) {
    return role != lsystem::Roles::none && roles.of(symbol) == role;
  };
  std::vector<Belonging> made;
  made.reserve(static_cast<std::size_t>(string.modules));
  std::vector<std::uint8_t> around;  // of the branches that are open
  std::uint8_t area = 0;
  for (const std::uint32_t* module = string.begin(); module < string.end(); module += lsystem::words_of(*module)) {
    const std::uint32_t symbol = lsystem::symbol_of(*module);
    if (symbol == lsystem::push_symbol) around.push_back(area);
    if (symbol == lsystem::pop_symbol && !around.empty()) {
      area = around.back();
      around.pop_back();
    }
    if (plays(symbol, area_role)) area = number_of(module);
    const bool main = lsystem::has_lineage(*module) && plays(lsystem::origin_of(module).ancestors & 0xffff, main_role);
    made.push_back({area, main});
  }
  return made;
}

}  // namespace panicle::grammar
