// Reads the modules of an axiom or a successor: symbols with their arguments.
#pragma once

#include <string_view>
#include <vector>

#include "expression/token_reader.hpp"
#include "lsystem/syntax/grammar.hpp"

namespace panicle::lsystem {

class ModuleReader : public TokenReader {
 public:
  using TokenReader::TokenReader;

 protected:
  // Whether the turtle has a command of that name.
  static bool is_turtles(std::string_view symbol);

  // Reads a name, a sign of the turtle, a query or a surface.
  bool symbol(std::string_view& name);
  // Reads modules up to a `:` or the statement's end, with balanced brackets.
  bool modules(std::vector<ModuleTree>& modules);

  std::size_t arrow_ = 0;     // of the production
  std::uint32_t system_ = 0;  // the L-system that is read
  Names systems_;             // that the text has somewhere
  Grammar grammar_;

 private:
  bool question(const Token& token, std::string_view& name);
  bool two_signs(const Token& token, std::string_view& name, const MessageCode<0>& otherwise);
  bool no_symbol(const Token& token);
  bool arguments(ModuleTree& module);
};

}  // namespace panicle::lsystem
