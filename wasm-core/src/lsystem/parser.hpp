// Text → tree (docs/grammar.md).
#pragma once

#include <string_view>

#include "lsystem/grammar.hpp"

namespace panicle::lsystem {

inline constexpr std::size_t most_parameters = 32;  // of one module

// `text` must outlive the tree. Errors: syntax, undefined (a function's name), limit; the first one found.
Result<Grammar> parse(std::string_view text);

}  // namespace panicle::lsystem
