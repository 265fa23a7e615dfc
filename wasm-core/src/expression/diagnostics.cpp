#include "expression/diagnostics.hpp"

namespace panicle::expression {

std::string sentence(const char* pattern, Pieces pieces) {
  std::string text;
  const std::string_view* piece = pieces.begin();
  for (; *pattern != 0; ++pattern) {
    if (*pattern == '%') {
      text.append(*piece++);
    } else {
      text.push_back(*pattern);
    }
  }
  return text;
}

Diagnostic error_at(Reason reason, const SourceLocation& place, const char* pattern, Pieces pieces) {
  return {reason, sentence(pattern, pieces), place.line, place.column};
}

}  // namespace panicle::expression
