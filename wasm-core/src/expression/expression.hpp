// Parser of expressions: tokens → postfix nodes.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "expression/expression_tree.hpp"
#include "expression/names.hpp"

namespace panicle::expression {

// `#define name(formals) body`: a function that is replaced by its body, arguments in place of formals, where it is
// called. Arguments are values, not text: f(1+1) with the body x*2 is 4.
struct Macro {
  std::vector<Named> formals;
  Expression body;
};

struct Macros {
  static constexpr std::size_t max_nodes = 100'000;  // that all calls of a text are replaced by

  Names names;             // by number
  std::vector<Macro> all;  // by number
  std::size_t nodes = 0;   // that calls have been replaced by so far
};

// Parses one expression from `tokens[at]` on, up to `end`, to a `)` or `,` that it did not open, or to a brace of a
// block, and leaves `at` there. Operators as in C, and `^` for powers (binds tightest, from the right), `=` for `==`.
// Explicit stacks in place of recursion; deeper than 256 is Reason::limit, and so are calls of macros that expand to
// more than Macros::max_nodes. `curves` are functions as well, by number. Errors: syntax, undefined (a function's
// name).
Result<Expression> parse_expression(std::span<const Token> tokens, std::size_t& at, std::size_t end,
                                    const Names& curves, Macros& macros);

// The place of `tokens[at]`, or just behind the last token before `end`.
SourceLocation place_of(std::span<const Token> tokens, std::size_t at, std::size_t end);

}  // namespace panicle::expression
