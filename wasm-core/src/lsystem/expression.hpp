// Tokens → expression.
#pragma once

#include <cstddef>
#include <span>

#include "lsystem/grammar.hpp"
#include "lsystem/names.hpp"

namespace panicle::lsystem {

// Reads one expression from `tokens[at]` on, up to `end` or to a `)` or `,` that it did not open, and leaves `at`
// there, or to a sign of a block. Operators as in C, and `^` for powers (binds tightest, from the right), `=` for `==`.
// Explicit stacks in place of recursion; deeper than 256 is Reason::limit. `curves` are functions as well, by number.
// Errors: syntax, undefined (a function's name).
Result<Expression> parse_expression(std::span<const Token> tokens, std::size_t& at, std::size_t end,
                                    const Names& curves);

// The place of `tokens[at]`, or just behind the last token before `end`.
Place place_of(std::span<const Token> tokens, std::size_t at, std::size_t end);

}  // namespace panicle::lsystem
