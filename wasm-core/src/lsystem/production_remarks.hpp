// Remarks on productions that no module of the text can meet.
#pragma once

#include <vector>

#include "lsystem/grammar.hpp"

namespace panicle::lsystem {

// In any order; each with the place of what it is about:
// - a module with another number of parameters than the productions of its symbol have, once for each number; a
//   production with a number that no module of its symbol has;
// - a production that an earlier one always precedes;
// - a context that is never met because a bracket stands between the two modules.
// What the text's strings show is all that is looked at: no string is derived. Time and memory are linear in the text.
std::vector<Remark> remarks_on_productions(const Grammar& grammar);

}  // namespace panicle::lsystem
