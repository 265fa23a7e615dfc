// Which growth area the modules of a string belong to, and which of them the main branch wrote: what a text says by
// two roles.
//
//   #role area Area   what stands behind Area(n), up to the end of its branch, belongs to area n
//   #role main C      what a C writes is the main branch's
#pragma once

#include <cstdint>
#include <vector>

#include "lsystem/lsystem.hpp"

namespace panicle::grammar {

struct Belonging {
  std::uint8_t area = 0;  // 0: none
  bool main = false;
};

// Of each module of a string by its place; nothing where the text declares neither role.
std::vector<Belonging> belongings(const lsystem::Program& program, const lsystem::String& string);

}  // namespace panicle::grammar
