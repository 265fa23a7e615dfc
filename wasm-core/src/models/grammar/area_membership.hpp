// The growth area of each module of a string, and whether the module belongs to the main branch, as a grammar declares
// them by a role:
//
//   #role area Area   modules behind Area(n), up to the end of the branch, belong to area n; modules behind Area(n, 1)
//                     belong to the main branch as well
#pragma once

#include <cstdint>
#include <vector>

#include "lsystem/lsystem.hpp"

namespace panicle::grammar {

struct AreaMembership {
  std::uint8_t area = 0;  // 0: none
  bool main = false;
};

// The area of each module, by its index in the string; empty where the grammar declares no such role.
std::vector<AreaMembership> area_memberships(const lsystem::Program& program, const lsystem::String& string);

}  // namespace panicle::grammar
