// The paper's grammars, compiled in: grammars/bunch/grape-bunch-1.lsys, -2, -3 as they stand in the repository.
#pragma once

#include <string_view>

namespace panicle::bunch {

// Text of L-system 1, 2 or 3; empty for any other number.
std::string_view builtin_grammar(int number);

}  // namespace panicle::bunch
