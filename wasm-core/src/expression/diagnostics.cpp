#include "expression/diagnostics.hpp"

namespace panicle::expression {

// An error at a place in a text.
Diagnostic error_at(Reason reason, const SourceLocation& place, const Message& problem) {
  return {reason, problem, place.line, place.column};
}

}  // namespace panicle::expression
