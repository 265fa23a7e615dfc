// Modules as text.
#pragma once

#include <string>

#include "lsystem/derivation/program.hpp"

namespace panicle::lsystem {

// `B(29)`: numbers with the fewest digits that give the same float back.
std::string module_text(const Program& program, const std::uint32_t* module);

}  // namespace panicle::lsystem
