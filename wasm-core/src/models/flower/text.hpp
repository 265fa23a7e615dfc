// Removes the parts of a flower's text that are not read: comments between @ and @, and the _ after a bracket in the
// thesis's tables.
#pragma once

#include <string>
#include <string_view>

#include "foundation/result.hpp"

namespace panicle::flower {

// The text with blanks in their place, so that lines and columns are unchanged. Error: syntax, for an unclosed comment.
Result<std::string> without_comments(std::string_view text);

}  // namespace panicle::flower
