#include "lsystem/syntax/module_reader.hpp"

#include "expression/code.hpp"
#include "expression/dialect_hints.hpp"
#include "expression/messages.generated.hpp"
#include "lsystem/messages.generated.hpp"
#include "lsystem/turtle/turtle_symbols.generated.hpp"

namespace panicle::lsystem {

// The turtle is the moving pen that draws a string.

namespace {

// The turtle's symbols that begin with a sign, for messages.
std::string commands_of_turtle(char sign) {
  std::string all;
  for (const TurtleSymbol& symbol : turtle_symbols)
    if (symbol.symbol[0] == sign && symbol.symbol.size() > 1) all.append(all.empty() ? "" : " ").append(symbol.symbol);
  return all;
}

}  // namespace

// Whether a symbol is the turtle's.
bool ModuleReader::is_turtles(std::string_view symbol) {
  for (const TurtleSymbol& turtle : turtle_symbols)
    if (turtle.symbol == symbol) return true;
  return false;
}

// Reads the name of a module. As all readers here, returns false with the error in `trouble()`.
bool ModuleReader::symbol(std::string_view& name) {
  if (at_ >= end_)
    return wrong(arrow_ < tokens_.size() && tokens_[arrow_].kind == TokenKind::arrow ? tokens_[arrow_].place : here(),
                 message(messages::lsystem::symbol_before_arrow));
  const Token& token = tokens_[at_];
  name = token.text;
  bool fine = true;
  if (token.is('?')) {
    fine = question(token, name);
  } else if (token.is('@') || token.is('~')) {
    fine =
        two_signs(token, name, token.is('~') ? messages::lsystem::surface_syntax : messages::lsystem::command_syntax);
    if (fine && token.is('@') && !is_turtles(name))
      return wrong(token.place, message(messages::lsystem::unknown_command, name, commands_of_turtle('@')));
  } else if (token.kind != TokenKind::name && !is_turtles(token.text)) {
    return no_symbol(token);
  }
  ++at_;
  return fine;
}

// Reads `?E`, `?P` and the like, or `?` and the name of an L-system that begins there.
bool ModuleReader::question(const Token& token, std::string_view& name) {
  if (!two_signs(token, name, messages::lsystem::query_syntax)) return false;
  if (is_turtles(name) || systems_.find(name.substr(1)) != Names::none) return true;
  return wrong(token.place, message(messages::lsystem::unknown_query, name));
}

// Reads a sign and a name that touches it as one symbol; `otherwise` is the error if there is none.
bool ModuleReader::two_signs(const Token& token, std::string_view& name, const MessageCode<0>& otherwise) {
  if (at_ + 1 >= end_ || tokens_[at_ + 1].kind != TokenKind::name || !touching(token, tokens_[at_ + 1]))
    return wrong(token.place, message(otherwise));
  name = {token.text.data(), token.text.size() + tokens_[at_ + 1].text.size()};
  ++at_;
  return true;
}

// Fails with a message on a token that is not a symbol.
bool ModuleReader::no_symbol(const Token& token) {
  if (const Hint hint = foreign_module(token.text)) return wrong(token.place, message(*hint));
  if (token.kind == TokenKind::number)
    return wrong(token.place, message(messages::lsystem::number_as_symbol, token.text));
  return wrong(token.place, message(messages::lsystem::not_a_module, token.text));
}

// Reads a string of modules, up to a colon or the end, and checks its brackets.
bool ModuleReader::modules(std::vector<ModuleTree>& modules) {
  struct Open {
    SourceLocation place;
    std::uint32_t system;
  };
  std::vector<Open> open;
  std::uint32_t system = system_;
  while (at_ < end_ && !on_sign(':')) {
    ModuleTree module;
    module.place = here();
    module.system = system;
    if (!symbol(module.name) || !arguments(module)) return false;
    if (module.name == "[") open.push_back({module.place, system});
    if (module.name == "]") {
      if (open.empty()) return wrong(module.place, message(messages::expression::never_opened, "]"));
      system = open.back().system;
      open.pop_back();
    }
    if (module.name[0] == '?' && !is_turtles(module.name)) {
      if (open.empty()) return wrong(module.place, message(messages::lsystem::part_without_brackets, module.name));
      system = systems_.find(module.name.substr(1)) + 1;
    }
    modules.push_back(std::move(module));
  }
  return open.empty() || wrong(open.back().place, message(messages::expression::never_closed, "["));
}

// Reads a module's arguments in parentheses, if there are any.
bool ModuleReader::arguments(ModuleTree& module) {
  if (!on_sign('(')) return true;
  const SourceLocation opened = here();
  ++at_;
  if (on_sign(')')) return ++at_, true;
  for (;;) {
    if (!expression_before(end_, module.arguments.emplace_back())) return false;
    if (module.arguments.size() > max_parameters) return too_many_parameters(opened);
    if (at_ >= end_) return wrong(opened, message(messages::expression::never_closed, "("));
    if (tokens_[at_++].is(')')) return true;
  }
}

}  // namespace panicle::lsystem
