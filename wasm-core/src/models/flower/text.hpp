// What is passed over in a flower's text before it is read: comments between @ and @, and the _ that stands behind a
// bracket in the thesis's tables.
#pragma once

#include <string>
#include <string_view>

#include "foundation/result.hpp"

namespace panicle::flower {

// The text with blanks in their place, so that lines and columns stay. Error: syntax, where a comment is not closed.
Result<std::string> without_comments(std::string_view text);

}  // namespace panicle::flower
