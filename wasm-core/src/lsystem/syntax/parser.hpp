// Parser of grammars (docs/language.md).
#pragma once

#include <string_view>

#include "expression/token_reader.hpp"
#include "lsystem/syntax/grammar.hpp"

namespace panicle::lsystem {

// `text` must outlive the tree. Errors: syntax, undefined (a function's name), limit; the first one found.
// `notation` is that of a text without `#turtle`.
Result<Grammar> parse(std::string_view text, Notation notation);

}  // namespace panicle::lsystem
