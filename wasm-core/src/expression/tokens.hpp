// Tokenizer. Comments and white space are skipped; each token has its line and column.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "expression/diagnostics.hpp"

namespace panicle::expression {

// A sign is one character: `//` is two rolls in a string of modules, and the parser of expressions recognises `==` or
// `&&` in two adjacent signs.
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
  // Compares a keyword, given in lower case, ignoring the case of its letters as in cpfg: Axiom, EndLsystem.
  bool is_keyword(std::string_view word) const;
};

// Whether two tokens are adjacent.
inline bool touching(const Token& token, const Token& next) {
  return token.text.data() + token.text.size() == next.text.data();
}

// The kind of text: strings of modules; or rules as papers print them, where an arrow may be short (->, →), a name may
// have a part (volume.h), words may be quoted, and a number may be in degrees (60°).
enum class Writing : std::uint8_t { modules, rules };

// The tokens of a text. `text` must outlive them. Errors: syntax.
Result<std::vector<Token>> tokenize(std::string_view text, Writing writing = Writing::modules);

}  // namespace panicle::expression
