// Tokens → expression.
#pragma once

#include <cstddef>
#include <span>

#include "lsystem/grammar.hpp"

namespace panicle::lsystem {

// Reads one expression from `tokens[at]` on, up to `end` or to a `)` or `,` that it did not open, and leaves `at`
// there. Operators as in C, and `^` for powers (binds tightest, from the right), `=` for `==`. Explicit stacks in place
// of recursion; deeper than 256 is Reason::limit. Errors: syntax, undefined (a function's name).
Result<Expression> parse_expression(std::span<const Token> tokens, std::size_t& at, std::size_t end);

// The place of `tokens[at]`, or just behind the last token before `end`.
Place place_of(std::span<const Token> tokens, std::size_t at, std::size_t end);

}  // namespace panicle::lsystem
