#include "expression/token_reader.hpp"

#include "expression/code.hpp"
#include "expression/messages.generated.hpp"

namespace panicle::expression {

// Sets the error, and returns false.
bool TokenReader::fail(Reason reason, const SourceLocation& place, const Message& problem) {
  trouble_ = error_at(reason, place, problem);
  return false;
}

// The current token for messages: quoted, or the end of the text.
Message TokenReader::found_text() const {
  return at_ < end_ ? message(messages::expression::term_quoted, found()) : message(messages::expression::term_end);
}

// Skips a required sign.
bool TokenReader::expect(char sign) {
  if (!on_sign(sign))
    return wrong(here(), message(messages::expression::expected_sign, std::string_view(&sign, 1), found_text()));
  ++at_;
  return true;
}

// Skips a required sign; `otherwise` is the error if it is missing.
bool TokenReader::expect(char sign, const MessageCode<0>& otherwise) {
  if (!on_sign(sign)) return wrong(here(), message(otherwise));
  ++at_;
  return true;
}

// The first token of the next line.
std::size_t TokenReader::end_of_line(std::size_t at) const {
  do ++at;
  while (at < tokens_.size() && !tokens_[at].first_on_line);
  return at;
}

// The arrow on the rest of a line; the line's end if there is none.
std::size_t TokenReader::arrow_of_line(std::size_t at) const {
  const std::size_t end = end_of_line(at);
  while (at < end && tokens_[at].kind != TokenKind::arrow) ++at;
  return at;
}

// Reads an expression that ends before the token `end`.
bool TokenReader::expression_before(std::size_t end, Expression& expression) {
  Result<Expression> result = parse_expression(tokens_, at_, end, curves_, macros_);
  if (!result) {
    trouble_ = result.error();
    return false;
  }
  expression = std::move(result.value());
  return true;
}

// Reads an expression that ends exactly at the token `end`.
bool TokenReader::expression_to(std::size_t end, Expression& expression) {
  if (!expression_before(end, expression)) return false;
  return at_ == end || wrong(here(), message(messages::expression::unexpected, found_text()));
}

// Reads formal parameters in parentheses, if there are any, and appends them.
bool TokenReader::formals(std::vector<Named>& formals) {
  if (!on_sign('(')) return true;
  const SourceLocation opened = here();
  const std::size_t before = formals.size();
  ++at_;
  while (!on_sign(')')) {
    if (at_ >= end_) return wrong(opened, message(messages::expression::never_closed, "("));
    if (formals.size() > before) {
      if (!on_sign(',')) return wrong(here(), message(messages::expression::expected_sign, ",", found_text()));
      ++at_;
    }
    if (!on_name()) return wrong(here(), message(messages::expression::parameter_name_expected, found_text()));
    if (formals.size() - before == max_parameters) return too_many_parameters(opened);
    formals.push_back({tokens_[at_].text, tokens_[at_].place});
    ++at_;
  }
  ++at_;
  return true;
}

bool TokenReader::too_many_parameters(const SourceLocation& place) {
  return fail(Reason::limit, place, message(messages::expression::too_many_parameters));
}

}  // namespace panicle::expression
