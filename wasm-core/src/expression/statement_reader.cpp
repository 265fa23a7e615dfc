#include "expression/statement_reader.hpp"

#include "expression/messages.generated.hpp"
#include "expression/operations.hpp"

namespace panicle::expression {

// The error of a text that is longer than the limits allow; none otherwise.
Diagnostic check_length(std::string_view text, const Limits& limits) {
  if (text.size() <= limits.text_bytes) return {};
  return error_at(Reason::limit, {}, message(messages::expression::text_too_long, limits.text_bytes));
}

// The names of all functions for messages, `own` first.
std::string known_functions(std::string_view own) {
  std::string known(own);
  for (const Function& function : functions)
    if (!is_space_query(function.op)) known.append(", ").append(function.name);
  return known;
}

// The token at which the statement ends: the first one of a line that does not continue it.
std::size_t StatementReader::statement_end(std::size_t begin) const {
  std::size_t open = 0;
  for (std::size_t at = begin; at < tokens_.size(); ++at) {
    const Token& token = tokens_[at];
    if (at > begin && token.first_on_line && open == 0 && !syntax_.continues(tokens_[at - 1], token)) return at;
    count_brackets(syntax_.brackets, token, open);
  }
  return tokens_.size();
}

// Whether the whole statement has been read; an error if not.
bool StatementReader::at_statement_end() {
  return at_ >= end_ || wrong(here(), message(messages::expression::unexpected_in_statement, found_text()));
}

// Compiles an expression; returns false with the error in `trouble_`.
bool StatementReader::compile(const Expression& tree, Value& value) {
  const std::uint32_t begin = lowering_.here();
  const auto source = lowering_.lower(tree);
  if (!source) {
    trouble_ = source.error();
    return false;
  }
  value = {true, {begin, lowering_.here()}, source.value(), tree.place};
  return true;
}

// Counts the brackets that are open after a token.
void StatementReader::count_brackets(std::string_view brackets, const Token& token, std::size_t& open) {
  for (const char bracket : brackets) {
    if (token.is(bracket)) ++open;
    if (token.is(bracket == '(' ? ')' : bracket == '[' ? ']' : '}') && open > 0) --open;
  }
}

}  // namespace panicle::expression
