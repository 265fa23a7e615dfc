#include "lsystem/diagnostics.hpp"

namespace panicle::lsystem {

std::string joined(Pieces pieces) {
  std::string sentence;
  for (const std::string_view piece : pieces) sentence.append(piece);
  return sentence;
}

Diagnostic error_at(Reason reason, const Place& place, Pieces pieces) {
  return {reason, joined(pieces), place.line, place.column};
}

}  // namespace panicle::lsystem
