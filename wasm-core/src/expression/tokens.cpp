#include "expression/tokens.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "expression/dialect_hints.hpp"
#include "expression/messages.generated.hpp"
#include "expression/number_text.hpp"

namespace panicle::expression {
namespace {

constexpr std::string_view signs = "+-*/^%&|\\!()[]{}.,:;=<>?#$~@'";

bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }

// Typographic characters that are pasted from papers, and their spelling in this notation.
struct Spelling {
  char32_t pasted;
  std::string_view written;
};
constexpr std::array<Spelling, 17> spellings = {{{U'→', "-->"},
                                                 {U'⟶', "-->"},
                                                 {U'−', "-"},
                                                 {U'–', "-"},
                                                 {U'·', "*"},
                                                 {U'×', "*"},
                                                 {U'÷', "/"},
                                                 {U'≤', "<="},
                                                 {U'≥', ">="},
                                                 {U'≠', "!="},
                                                 {U'∧', {}},
                                                 {U'∨', "||"},
                                                 {U'′', "'"},
                                                 {U'’', "'"},
                                                 {U'∼', "~"},
                                                 {U'≡', "=="},
                                                 {U'⇒', "-->"}}};

// Whether a name may contain the character: letters of every script are allowed; punctuation, arrows, mathematical
// signs and the like are not.
bool is_letter(char32_t c) {
  if (c < 0x80) return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z');
  struct Block {
    char32_t first, last;
  };
  static constexpr Block excluded[] = {{0x80, 0xbf},     {0xd7, 0xd7},     {0xf7, 0xf7},       {0x2000, 0x206f},
                                       {0x2190, 0x2bff}, {0x3000, 0x303f}, {0xe000, 0xf8ff},   {0xfe00, 0xfe6f},
                                       {0xfeff, 0xfeff}, {0xfff0, 0xffff}, {0x1f000, 0x10ffff}};
  for (const Block& block : excluded)
    if (c >= block.first && c <= block.last) return false;
  return true;
}

struct CodePoint {
  char32_t value = 0;
  std::uint32_t bytes = 0;  // 0: not UTF-8
};

// Decodes the first character of a UTF-8 text, which is not empty. `bytes` is 0 where it is not UTF-8; overlong forms
// of two bytes and lead bytes beyond U+10FFFF are refused.
CodePoint decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::uint32_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4) return {};
  char32_t value = lead & (0x7fu >> bytes);
  for (std::uint32_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    value = value << 6 | (byte(i) & 0x3f);
  }
  return {value, bytes};
}

// Divides a text into tokens, with their lines and columns. Methods that return a bool return false with the error in
// `error_`.
class Tokenizer {
 public:
  Tokenizer(std::string_view text, Writing writing) : text_(text), of_rules_(writing == Writing::rules) {
    if (text_.substr(0, 3) == "\xef\xbb\xbf") at_ = 3;  // a byte order mark is no part of the text
  }

  // Reads all tokens; the first error ends it.
  Result<std::vector<Token>> run() {
    while (pass_over_space()) {
      if (!next_token()) break;
      first_on_line_ = false;
    }
    if (error_.reason != Reason::none) return error_;
    return std::move(tokens_);
  }

 private:
  // The byte at an offset from the current place; 0 behind the text.
  char32_t peek(std::size_t offset = 0) const {
    return at_ + offset < text_.size() ? static_cast<unsigned char>(text_[at_ + offset]) : 0;
  }

  bool fail(const SourceLocation& place, const Message& problem) {
    error_ = error_at(Reason::syntax, place, problem);
    return false;
  }

  // Moves on by a character of some bytes.
  void advance(std::uint32_t bytes) {
    at_ += bytes;
    ++place_.column;
  }

  // Begins a line, for places in messages.
  void begin_line() {
    ++place_.line;
    place_.column = 1;
    first_on_line_ = true;
    line_begin_ = at_;
    in_comment_.reset();
  }

  // Skips white space and comments. Returns whether a token follows.
  bool pass_over_space() {
    while (at_ < text_.size()) {
      const char32_t c = peek();
      if (c == '/' && peek(1) == '*') {
        if (!pass_over_comment()) return false;
      } else if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
        advance(1);
        if (c == '\n') begin_line();
      } else {
        return true;
      }
    }
    return false;
  }

  // Skips a comment between /* and */.
  bool pass_over_comment() {
    const SourceLocation start = place_;
    advance(1);
    advance(1);
    while (at_ < text_.size()) {
      if (peek() == '*' && peek(1) == '/') {
        advance(1);
        advance(1);
        return true;
      }
      const char32_t c = peek();
      const std::uint32_t bytes = decode(text_.substr(at_)).bytes;
      advance(bytes == 0 ? 1 : bytes);
      if (c == '\n') begin_line();
    }
    return fail(start, message(messages::expression::comment_never_closed));
  }

  // Reads a token.
  bool next_token() {
    const SourceLocation place = place_;
    const std::size_t start = at_;
    const CodePoint point = decode(text_.substr(at_));
    if (is_letter(point.value) && point.bytes > 0) return name(start, place);
    if (is_digit(point.value) || (point.value == '.' && is_digit(peek(1)))) return number(start, place);
    if (text_.substr(at_, 3) == "-->") {
      for (int i = 0; i < 3; ++i) advance(1);
      return add(TokenKind::arrow, start, place);
    }
    if (of_rules_ && (text_.substr(at_, 2) == "->" || point.value == U'→')) {
      advance(point.bytes);
      if (point.value == '-') advance(1);
      return add(TokenKind::arrow, start, place);
    }
    if (of_rules_ && point.value == '"') return quoted(place);
    if (point.bytes == 1 && signs.find(text_[at_]) != std::string_view::npos) {
      static constexpr std::string_view of_prose = "'.,;";
      if (of_prose.find(text_[at_]) != std::string_view::npos && in_comment()) return unknown(point);
      advance(1);
      return add(TokenKind::sign, start, place);
    }
    return unknown(point);
  }

  // Adds a token from `start` to the current place.
  bool add(TokenKind kind, std::size_t start, const SourceLocation& place, float value = 0) {
    tokens_.push_back({kind, first_on_line_, place, text_.substr(start, at_ - start), value});
    return true;
  }

  // Reads a name; in rules it may have parts separated by points.
  bool name(std::size_t start, const SourceLocation& place) {
    while (at_ < text_.size()) {
      const CodePoint point = decode(text_.substr(at_));
      const bool part = of_rules_ && point.value == '.' && is_letter(decode(text_.substr(at_ + 1)).value);
      if (point.bytes == 0 || !(is_letter(point.value) || is_digit(point.value) || point.value == '_' || part)) break;
      advance(point.bytes);
    }
    return add(TokenKind::name, start, place);
  }

  // Reads a text in quotes, without them.
  bool quoted(const SourceLocation& place) {
    advance(1);
    const std::size_t begin = at_, end = text_.find_first_of("\"\n", at_);
    if (end == std::string_view::npos || text_[end] == '\n')
      return fail(place, message(messages::expression::quotes_never_closed));
    while (at_ < end) {
      const std::uint32_t bytes = decode(text_.substr(at_)).bytes;
      advance(bytes == 0 ? 1 : bytes);
    }
    tokens_.push_back({TokenKind::quoted, first_on_line_, place, text_.substr(begin, end - begin), 0});
    advance(1);
    return true;
  }

  // Skips digits.
  void digits() {
    while (is_digit(peek())) advance(1);
  }

  // Reads a number; in rules a degree sign may follow.
  bool number(std::size_t start, const SourceLocation& place) {
    digits();
    if (peek() == '.') advance(1);
    digits();
    const bool has_sign = peek(1) == '+' || peek(1) == '-';
    if ((peek() == 'e' || peek() == 'E') && is_digit(peek(has_sign ? 2 : 1))) {
      advance(1);
      if (has_sign) advance(1);
      digits();
    }
    const double precise = double_from(text_.substr(start, at_ - start));
    const auto value = static_cast<float>(precise);
    if (std::isinf(value)) return fail(place, message(messages::expression::number_too_large));
    add(TokenKind::number, start, place, value);
    tokens_.back().precise = precise;
    if (of_rules_ && text_.substr(at_, 2) == "°") advance(2);
    return true;
  }

  // Fails with a message on a character that is not allowed, with advice if it is a typographic one.
  bool unknown(const CodePoint& point) {
    if (point.bytes == 0) return fail(place_, message(messages::expression::not_utf8));
    if (point.value < 0x20 || point.value == 0x7f)
      return fail(place_, message(messages::expression::control_character));
    const std::string character(text_.substr(at_, point.bytes));
    if (in_comment()) return fail(place_, message(messages::expression::comment_syntax));
    if (of_rules_ && (point.value == U'“' || point.value == U'”'))
      return fail(place_, message(messages::expression::plain_quotes, character));
    for (const Spelling& spelling : spellings)
      if (spelling.pasted == point.value && spelling.written.empty())
        return fail(place_, message(messages::expression::foreign_wedge, character));
      else if (spelling.pasted == point.value)
        return fail(place_, message(messages::expression::foreign_character, character, spelling.written));
    if (const Hint hint = foreign_sign(character)) return fail(place_, message(*hint));
    return fail(place_, message(messages::expression::unknown_character, character));
  }

  // Whether the line begins as `// two words`. Evaluated once a line.
  bool in_comment() {
    if (!in_comment_) in_comment_ = begins_as_comment();
    return *in_comment_;
  }

  // Whether the line begins with `//` and two words, the comment of other languages.
  bool begins_as_comment() const {
    const std::size_t begin = text_.find_first_not_of(" \t", line_begin_);
    if (begin == std::string_view::npos || text_.substr(begin, 2) != "//") return false;
    const std::size_t first = text_.find_first_not_of(" \t", begin + 2);
    const auto letter = [&](std::size_t at) { return at < text_.size() && is_letter(decode(text_.substr(at)).value); };
    std::size_t behind = first;
    while (letter(behind)) behind += decode(text_.substr(behind)).bytes;
    return letter(first) && behind < text_.size() && text_[behind] == ' ' && letter(behind + 1);
  }

  std::string_view text_;
  bool of_rules_;
  std::size_t at_ = 0;
  SourceLocation place_{1, 1};
  bool first_on_line_ = true;
  std::size_t line_begin_ = 0;
  std::optional<bool> in_comment_;  // of this line, once it is known
  std::vector<Token> tokens_;
  Diagnostic error_;
};

}  // namespace

// Whether the token is that name, in any mixture of upper and lower case; `word` is in lower case.
bool Token::is_keyword(std::string_view word) const {
  return kind == TokenKind::name &&
         std::equal(text.begin(), text.end(), word.begin(), word.end(), [](char here, char small) {
           return here == small || (here >= 'A' && here <= 'Z' && here - 'A' + 'a' == small);
         });
}

// Splits a text into tokens; an error for characters that no token has.
Result<std::vector<Token>> tokenize(std::string_view text, Writing writing) { return Tokenizer(text, writing).run(); }

}  // namespace panicle::expression
