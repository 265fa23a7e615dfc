// The base of the readers of languages of statements: flower, growth and stand.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "expression/code.hpp"
#include "expression/lowering.hpp"
#include "expression/messages.generated.hpp"
#include "expression/token_reader.hpp"
#include "foundation/limits.hpp"

namespace panicle::expression {

// The error for a text that is longer than the limit; reason none for others.
Diagnostic check_length(std::string_view text, const Limits& limits);
// The names of a language's own functions, and of all others that it may call, for messages.
std::string known_functions(std::string_view own);

// Where a language's statements end.
struct StatementSyntax {
  std::string_view brackets;  // opening ones; within them a statement continues in the next line
  // Whether a statement continues in the next line outside of brackets. `last`: the line's last token, `next`: the
  // first of the next line.
  bool (*continues)(const Token& last, const Token& next);
};

// A name and the function that reads the statement or the setting that begins with it.
template <class Read>
struct NamedReader {
  std::string_view name;
  Read read;
};

class StatementReader : protected TokenReader {
 public:
  const Diagnostic& trouble() const { return trouble_; }

 protected:
  // All must outlive the reader.
  StatementReader(std::span<const Token> tokens, const StatementSyntax& syntax, Lowering& lowering)
      : TokenReader(tokens), lowering_(lowering), syntax_(syntax) {}

  // Reads the statements one by one: `read()` reads from `at_` to `end_`.
  template <class Read>
  bool read_statements(Read read) {
    while (at_ < tokens_.size()) {
      end_ = statement_end(at_);
      if (!read() || !at_statement_end()) return false;
    }
    return true;
  }
  std::size_t statement_end(std::size_t begin) const;
  // Fails where tokens are left of a statement.
  bool at_statement_end();
  // The row of a table whose name the current token is; null for none.
  template <class Row, std::size_t count>
  const Row* find_named(const Row (&rows)[count]) const {
    for (const Row& row : rows)
      if (on(row.name)) return &row;
    return nullptr;
  }

  // The first token from `at` to `end` outside of brackets for which `is(token)`; `end` for none.
  template <class Is>
  std::size_t find_outside(std::string_view brackets, std::size_t at, std::size_t end, Is is) const {
    for (std::size_t open = 0; at < end; ++at) {
      if (open == 0 && is(tokens_[at])) return at;
      count_brackets(brackets, tokens_[at], open);
    }
    return end;
  }
  // Whether the next token is that name.
  bool on(std::string_view name) const { return at_ < end_ && tokens_[at_].is(name); }
  // Whether the token at an index is an opening parenthesis.
  bool opens(std::size_t at) const { return at < end_ && tokens_[at].is('('); }
  bool expect_comma() { return expect(','); }
  // Sets the error for a bracket, opened there, that is never closed; returns false.
  bool never_closed(const SourceLocation& opened, std::string_view bracket = "(") {
    return wrong(opened, message(messages::expression::never_closed, bracket));
  }

  // Compiles an expression into code that is appended to the others'.
  bool compile(const Expression& tree, Value& value);

  Lowering& lowering_;

 private:
  // Keeps count of the brackets that are open behind a token.
  static void count_brackets(std::string_view brackets, const Token& token, std::size_t& open);

  const StatementSyntax& syntax_;
};

}  // namespace panicle::expression
