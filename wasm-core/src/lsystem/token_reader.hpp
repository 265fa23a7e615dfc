// What all readers of a grammar's text share: where they stand in it, and modules, symbols and expressions.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lsystem/expression.hpp"
#include "lsystem/grammar.hpp"
#include "lsystem/names.hpp"

namespace panicle::lsystem {

inline constexpr std::size_t most_parameters = 32;  // of one module

class TokenReader {
 public:
  explicit TokenReader(std::span<const Token> tokens) : tokens_(tokens) {}

 protected:
  bool fail(Reason reason, const Place& place, const char* pattern, Pieces pieces = {});
  bool wrong(const Place& place, const char* pattern, Pieces pieces = {}) {
    return fail(Reason::syntax, place, pattern, pieces);
  }

  static bool is_turtles(std::string_view symbol);
  Place here() const { return place_of(tokens_, at_, end_); }
  bool on_sign(char sign) const { return at_ < end_ && tokens_[at_].is(sign); }
  bool on_name() const { return at_ < end_ && tokens_[at_].kind == TokenKind::name; }
  std::string_view found() const { return at_ < end_ ? tokens_[at_].text : std::string_view("the end"); }
  // Passes over a sign that has to be here.
  bool expect(char sign, const char* otherwise);
  bool next_is(std::size_t at, char sign) const { return at + 1 < end_ && tokens_[at + 1].is(sign); }

  std::size_t end_of_line(std::size_t at) const;
  // The first arrow of the line that begins at `at`, or the line's end.
  std::size_t arrow_of_line(std::size_t at) const;

  bool expression_before(std::size_t end, Expression& expression);
  // An expression that reaches exactly to `end`.
  bool expression_to(std::size_t end, Expression& expression);

  // A name, a sign of the turtle, a question or a surface.
  bool symbol(std::string_view& name);
  // Adds the names in parentheses, where there are any.
  bool formals(std::vector<Named>& formals);
  // Modules up to a `:` or the statement's end, their brackets balanced.
  bool modules(std::vector<ModuleTree>& modules);

  std::span<const Token> tokens_;
  std::size_t at_ = 0;
  std::size_t end_ = 0;       // of the statement
  std::size_t arrow_ = 0;     // of the production
  std::uint32_t system_ = 0;  // the L-system that is read
  Names curves_;              // in the order of the text
  Macros macros_;             // likewise
  Names systems_;             // that the text has somewhere
  Grammar grammar_;
  Diagnostic trouble_;

 private:
  bool question(const Token& token, std::string_view& name);
  bool two_signs(const Token& token, std::string_view& name, const char* otherwise);
  bool no_symbol(const Token& token);
  bool arguments(ModuleTree& module);
  bool too_many(const Place& place);
};

}  // namespace panicle::lsystem
