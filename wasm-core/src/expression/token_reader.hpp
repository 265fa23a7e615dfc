// The base of the readers of all languages: a position in the tokens of a text, signs, names and expressions.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "expression/expression.hpp"
#include "expression/expression_tree.hpp"
#include "expression/names.hpp"

namespace panicle::expression {

class TokenReader {
 public:
  explicit TokenReader(std::span<const Token> tokens) : tokens_(tokens) {}

 protected:
  bool fail(Reason reason, const SourceLocation& place, const Message& problem);
  // Sets a syntax error; returns false.
  bool wrong(const SourceLocation& place, const Message& problem) { return fail(Reason::syntax, place, problem); }

  // The line and column of the next token.
  SourceLocation here() const { return place_of(tokens_, at_, end_); }
  // Whether the next token is that sign, or a name.
  bool on_sign(char sign) const { return at_ < end_ && tokens_[at_].is(sign); }
  bool on_name() const { return at_ < end_ && tokens_[at_].kind == TokenKind::name; }
  // The next token as an error message shows it.
  std::string_view found() const { return at_ < end_ ? tokens_[at_].text : std::string_view("the end"); }
  // The token here in quotes, or the end of the statement, for messages.
  Message found_text() const;
  // Consumes a required sign.
  bool expect(char sign, const MessageCode<0>& otherwise);
  bool expect(char sign);
  // Whether the token after that index is a sign.
  bool next_is(std::size_t at, char sign) const { return at + 1 < end_ && tokens_[at + 1].is(sign); }

  std::size_t end_of_line(std::size_t at) const;
  // The first arrow of the line that begins at `at`, or the line's end.
  std::size_t arrow_of_line(std::size_t at) const;

  bool expression_before(std::size_t end, Expression& expression);
  // An expression that reaches exactly to `end`.
  bool expression_to(std::size_t end, Expression& expression);

  // Adds the names in parentheses, where there are any.
  bool formals(std::vector<Named>& formals);
  // Fails with the error of a module with too many parameters.
  bool too_many_parameters(const SourceLocation& place);

  std::span<const Token> tokens_;
  std::size_t at_ = 0;
  std::size_t end_ = 0;  // of the statement
  Names curves_;         // in the order of the text
  Macros macros_;        // likewise
  Diagnostic trouble_;
};

}  // namespace panicle::expression
