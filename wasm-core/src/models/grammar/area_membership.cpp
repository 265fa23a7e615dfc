#include "models/grammar/area_membership.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "lsystem/derivation/program.hpp"
#include "lsystem/derivation/words.hpp"

namespace panicle::grammar {
namespace {

constexpr std::string_view area_role = "area";

// The parameter at index `place` of a module in the string, whose words follow its head; 0 if it has fewer.
float parameter_of(const std::uint32_t* module, std::uint32_t place) {
  float value = 0;
  if (lsystem::parameters_of(*module) > place) std::memcpy(&value, module + 1 + place, sizeof value);
  return value;
}

// The area number (1 … 255; 0 for none) and whether it is the main branch, from the parameters of a module of the role
// "area".
AreaMembership read_membership(const std::uint32_t* module) {
  const float number = parameter_of(module, 0);
  return {number >= 1 && number <= 255 ? static_cast<std::uint8_t>(number) : std::uint8_t{0},
          parameter_of(module, 1) == 1};
}

}  // namespace

// For each module of the string, the area that the last area module before it, in its branch, names. Empty if the text
// declares no such module.
std::vector<AreaMembership> area_memberships(const lsystem::Program& program, const lsystem::String& string) {
  const lsystem::Roles& roles = lsystem::roles(program);
  const auto found = std::find(roles.names.begin(), roles.names.end(), area_role);
  if (found == roles.names.end()) return {};
  const auto role = static_cast<std::uint32_t>(found - roles.names.begin());
  std::vector<AreaMembership> made;
  made.reserve(static_cast<std::size_t>(string.modules));
  std::vector<AreaMembership> around;  // of the open branches
  AreaMembership now;
  for (const std::uint32_t* module = string.begin(); module < string.end(); module += lsystem::words_of(*module)) {
    const std::uint32_t symbol = lsystem::symbol_of(*module);
    if (symbol == lsystem::push_symbol) around.push_back(now);
    if (symbol == lsystem::pop_symbol && !around.empty()) {
      now = around.back();
      around.pop_back();
    }
    if (roles.of(symbol) == role) now = read_membership(module);
    made.push_back(now);
  }
  return made;
}

}  // namespace panicle::grammar
