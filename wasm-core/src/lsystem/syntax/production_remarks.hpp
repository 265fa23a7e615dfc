// Remarks on productions that can never be applied.
#pragma once

#include <vector>

#include "lsystem/syntax/grammar.hpp"

namespace panicle::lsystem {

// The remarks on a grammar, in any order, each with the place that it is about:
// - a module with another number of parameters than the productions of its symbol have, once for each number;
// - a production with a number that no module of its symbol has;
// - a production that an earlier one always precedes;
// - a context that is never met because a bracket stands between the two modules.
// Only the axiom and the successors are examined: no string is derived. Time and memory are linear in the text.
std::vector<Remark> remarks_on_productions(const Grammar& grammar);

}  // namespace panicle::lsystem
