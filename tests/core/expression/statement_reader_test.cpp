#include "expression/statement_reader.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "foundation/english.hpp"

using namespace panicle;
using namespace panicle::expression;

namespace {

constexpr StatementSyntax syntax{"(",
                                 [](const Token& last, const Token& next) { return last.is(',') || next.is(','); }};

// Reads `let` and a number in a statement each; names the statements by their first tokens.
class LetReader : StatementReader {
 public:
  LetReader(std::span<const Token> tokens, Lowering& lowering) : StatementReader(tokens, syntax, lowering) {}

  bool run() {
    return read_statements([this] { return statement(); });
  }
  using StatementReader::trouble;
  std::vector<std::pair<std::size_t, std::size_t>> read;  // first token of each statement, and its end

 private:
  bool let() {
    ++at_;
    Expression tree;
    Value value;
    return expression_before(find_outside("(", at_, end_, [](const Token& token) { return token.is(','); }), tree) &&
           compile(tree, value);
  }
  bool statement() {
    static constexpr NamedReader<bool (LetReader::*)()> statements[] = {{"let", &LetReader::let}};
    read.emplace_back(at_, end_);
    const auto* const known = find_named(statements);
    return known != nullptr ? (this->*known->read)() : never_closed(here(), "[");
  }
};

struct Outcome {
  std::vector<std::pair<std::size_t, std::size_t>> statements;
  std::string error;
};

Outcome read(std::string_view text) {
  const auto tokens = tokenize(text, Writing::rules);
  Code code;
  Lowering lowering(code);
  lowering.begin_production({}, 0);
  LetReader reader(tokens.value(), lowering);
  const bool fine = reader.run();
  const Diagnostic& trouble = reader.trouble();
  return {
      reader.read,
      fine ? "" : std::to_string(trouble.line) + ":" + std::to_string(trouble.column) + " " + english(trouble.message)};
}

}  // namespace

TEST_CASE("a statement ends with its line, but for open brackets and signs that something has to follow") {
  using Statements = std::vector<std::pair<std::size_t, std::size_t>>;
  CHECK(read("let 1\nlet 2").statements == Statements{{0, 2}, {2, 4}});
  CHECK(read("let (1\n+ 2)\nlet 3").statements == Statements{{0, 6}, {6, 8}});
  CHECK(read("let 1 ,\nlet 2").statements == Statements{{0, 5}});
  CHECK(read("").statements.empty());
}

TEST_CASE("errors of statements have line and column") {
  CHECK(read("let min(1, 2)").error.empty());
  CHECK(read("let 1\nlet 2, 3").error == "2:6 “,” is not allowed here; delete it, or start a new line.");
  CHECK(read("let 1\n  set 2").error == "2:3 “[” is never closed; add the closing bracket.");
  CHECK(read("let none").error.substr(0, 4) == "1:5 ");
}

TEST_CASE("a text longer than the limit is an error without a place") {
  Limits limits;
  limits.text_bytes = 3;
  CHECK(check_length("abc", limits).reason == Reason::none);
  const Diagnostic trouble = check_length("abcd", limits);
  CHECK(trouble.reason == Reason::limit);
  CHECK(trouble.line == 0);
  CHECK(english(trouble.message) == "The grammar is longer than the limit of 3 bytes; shorten it.");
}
