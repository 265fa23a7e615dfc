// Remarks on parts of a text that the engine ignores.
#pragma once

#include <vector>

#include "lsystem/syntax/grammar.hpp"

namespace panicle::lsystem {

// Returns all remarks on the text alone, in its order, once for each symbol or notation.
std::vector<Remark> remarks_on(const Grammar& grammar);

}  // namespace panicle::lsystem
