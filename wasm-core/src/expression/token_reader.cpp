#include "expression/token_reader.hpp"

#include "expression/code.hpp"

namespace panicle::expression {
bool TokenReader::fail(Reason reason, const SourceLocation& place, const char* pattern, Pieces pieces) {
  trouble_ = error_at(reason, place, pattern, pieces);
  return false;
}

bool TokenReader::expect(char sign, const char* otherwise) {
  if (!on_sign(sign)) return wrong(here(), otherwise, {found()});
  ++at_;
  return true;
}

std::size_t TokenReader::end_of_line(std::size_t at) const {
  do ++at;
  while (at < tokens_.size() && !tokens_[at].first_on_line);
  return at;
}

std::size_t TokenReader::arrow_of_line(std::size_t at) const {
  const std::size_t end = end_of_line(at);
  while (at < end && tokens_[at].kind != TokenKind::arrow) ++at;
  return at;
}

bool TokenReader::expression_before(std::size_t end, Expression& expression) {
  Result<Expression> result = parse_expression(tokens_, at_, end, curves_, macros_);
  if (!result) {
    trouble_ = result.error();
    return false;
  }
  expression = std::move(result.value());
  return true;
}

bool TokenReader::expression_to(std::size_t end, Expression& expression) {
  if (!expression_before(end, expression)) return false;
  return at_ == end || wrong(here(), "'%' cannot stand here; take it out.", {found()});
}

bool TokenReader::formals(std::vector<Named>& formals) {
  if (!on_sign('(')) return true;
  const SourceLocation opened = here();
  const std::size_t before = formals.size();
  ++at_;
  while (!on_sign(')')) {
    if (at_ >= end_) return wrong(opened, "This ( is never closed.");
    if (formals.size() > before) {
      if (!on_sign(',')) return wrong(here(), "A comma is expected here, not '%'.", {found()});
      ++at_;
    }
    if (!on_name()) return wrong(here(), "A predecessor's parameters are names; here is '%'.", {found()});
    if (formals.size() - before == most_parameters) return too_many_parameters(opened);
    formals.push_back({tokens_[at_].text, tokens_[at_].place});
    ++at_;
  }
  ++at_;
  return true;
}

bool TokenReader::too_many_parameters(const SourceLocation& place) {
  return fail(Reason::limit, place, "A module has at most 32 parameters; split it into two.");
}

}  // namespace panicle::expression
