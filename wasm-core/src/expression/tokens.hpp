// Text → tokens. Comments and white space are passed over; each token knows its line and column.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "expression/diagnostics.hpp"

namespace panicle::expression {

// A sign is one character: `//` is two rolls in a string of modules, and it is for the reader of an expression to see
// `==` or `&&` in two signs that touch.
enum class TokenKind : std::uint8_t { name, number, sign, arrow, quoted };

struct Token {
  TokenKind kind = TokenKind::sign;
  bool first_on_line = false;
  SourceLocation place;
  std::string_view text;  // part of the grammar's text
  float number = 0;
  double precise = 0;  // the same in double precision

  bool is(char sign) const { return kind == TokenKind::sign && text[0] == sign; }
  bool is(std::string_view name) const { return kind == TokenKind::name && text == name; }
  // The same for a word of a statement, given in small letters, which cpfg takes in either case: Axiom, EndLsystem.
  bool is_keyword(std::string_view word) const;
};

// Whether nothing stands between two tokens.
inline bool touching(const Token& token, const Token& next) {
  return token.text.data() + token.text.size() == next.text.data();
}

// The kind of text: strings of modules; or rules as papers print them, where an arrow may be short (->, →), a name may
// have a part (volume.h), words may be quoted, and a number may be in degrees (60°).
enum class Writing : std::uint8_t { modules, rules };

// The tokens of a text. `text` must outlive them. Errors: syntax.
Result<std::vector<Token>> tokenize(std::string_view text, Writing writing = Writing::modules);

}  // namespace panicle::expression
