// Places in a grammar's text, and error messages with them.
#pragma once

#include <cstdint>

#include "foundation/message.hpp"
#include "foundation/result.hpp"

namespace panicle::expression {

// A place in a text: line and column count from 1; columns count code points. 0 and 0 for errors that concern no text.
struct SourceLocation {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

Diagnostic error_at(Reason reason, const SourceLocation& place, const Message& problem);

}  // namespace panicle::expression
