// Places in a grammar's text, and error messages with them.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "foundation/result.hpp"

namespace panicle::expression {

// A place in a text: line and column count from 1; columns count code points. 0 and 0 for errors that concern no text.
struct SourceLocation {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

// The values that replace each % of a message pattern, in order. Messages are assembled by one function that is not
// inlined: concatenations would be a fifth of the .wasm.
using Pieces = std::initializer_list<std::string_view>;

std::string sentence(const char* pattern, Pieces pieces = {});
Diagnostic error_at(Reason reason, const SourceLocation& place, const char* pattern, Pieces pieces = {});

}  // namespace panicle::expression
