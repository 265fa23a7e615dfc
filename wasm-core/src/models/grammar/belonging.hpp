// Which growth area the modules of a string belong to, and which are the main branch's: what a text says by a role.
//
//   #role area Area   what stands behind Area(n), up to the end of its branch, belongs to area n; behind Area(n, 1) it
//                     is the main branch's as well
#pragma once

#include <cstdint>
#include <vector>

#include "lsystem/lsystem.hpp"

namespace panicle::grammar {

struct Belonging {
  std::uint8_t area = 0;  // 0: none
  bool main = false;
};

// Of each module of a string by its place; nothing where the text declares no such role.
std::vector<Belonging> belongings(const lsystem::Program& program, const lsystem::String& string);

}  // namespace panicle::grammar
