// What a text says and the engine passes over.
#pragma once

#include <vector>

#include "lsystem/syntax/grammar.hpp"

namespace panicle::lsystem {

// All that can be said of the text alone, in its order, once for each symbol or way of writing.
std::vector<Remark> remarks_on(const Grammar& grammar);

}  // namespace panicle::lsystem
