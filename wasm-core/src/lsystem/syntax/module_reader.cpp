#include "lsystem/syntax/module_reader.hpp"

#include "expression/code.hpp"
#include "expression/dialect_hints.hpp"
#include "lsystem/turtle/turtle_symbols.generated.hpp"

namespace panicle::lsystem {
namespace {

std::string commands_of_turtle(char sign) {
  std::string all;
  for (const TurtleSymbol& symbol : turtle_symbols)
    if (symbol.symbol[0] == sign && symbol.symbol.size() > 1) all.append(all.empty() ? "" : " ").append(symbol.symbol);
  return all;
}

}  // namespace

bool ModuleReader::is_turtles(std::string_view symbol) {
  for (const TurtleSymbol& turtle : turtle_symbols)
    if (turtle.symbol == symbol) return true;
  return false;
}

bool ModuleReader::symbol(std::string_view& name) {
  if (at_ >= end_)
    return wrong(arrow_ < tokens_.size() && tokens_[arrow_].kind == TokenKind::arrow ? tokens_[arrow_].place : here(),
                 "A symbol is expected before -->, on the same line.");
  const Token& token = tokens_[at_];
  name = token.text;
  bool fine = true;
  if (token.is('?')) {
    fine = question(token, name);
  } else if (token.is('@') || token.is('~')) {
    fine = two_signs(token, name,
                     token.is('~') ? "A surface is named in one word, such as ~leaf."
                                   : "A command is written in one word, such as @O(1).");
    if (fine && token.is('@') && !is_turtles(name))
      return wrong(token.place, "There is no %; there are %.", {name, commands_of_turtle('@')});
  } else if (token.kind != TokenKind::name && !is_turtles(token.text)) {
    return no_symbol(token);
  }
  ++at_;
  return fine;
}

// `?E`, `?P` and the like, or the name of an L-system that is begun.
bool ModuleReader::question(const Token& token, std::string_view& name) {
  if (!two_signs(token, name,
                 "A question is written in one word, ?E, ?P, ?H, ?L or ?U, and a part is begun by its name: [ "
                 "?leaf(0.5) F ]."))
    return false;
  if (is_turtles(name) || systems_.find(name.substr(1)) != Names::none) return true;
  return wrong(token.place,
               "There is no %; ?E asks the environment, ?P ?H ?L ?U the turtle, and ?name begins a part that the text "
               "has as Lsystem: name.",
               {name});
}

bool ModuleReader::two_signs(const Token& token, std::string_view& name, const char* otherwise) {
  if (at_ + 1 >= end_ || tokens_[at_ + 1].kind != TokenKind::name || !touching(token, tokens_[at_ + 1]))
    return wrong(token.place, otherwise);
  name = {token.text.data(), token.text.size() + tokens_[at_ + 1].text.size()};
  ++at_;
  return true;
}

bool ModuleReader::no_symbol(const Token& token) {
  if (!foreign_module(token.text).empty()) return wrong(token.place, "%", {foreign_module(token.text)});
  if (token.kind == TokenKind::number)
    return wrong(token.place,
                 "A symbol begins with a letter; '%' cannot be one. Write letters, such as o and i for 0 and 1; a "
                 "weight stands behind a colon.",
                 {token.text});
  return wrong(token.place, "'%' cannot stand in a string of modules; docs/turtle.md lists what can.", {token.text});
}

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
      if (open.empty()) return wrong(module.place, "This ] closes nothing.");
      system = open.back().system;
      open.pop_back();
    }
    if (module.name[0] == '?' && !is_turtles(module.name)) {
      if (open.empty())
        return wrong(module.place, "% begins a part up to the end of a branch; put brackets about it.", {module.name});
      system = systems_.find(module.name.substr(1)) + 1;
    }
    modules.push_back(std::move(module));
  }
  return open.empty() || wrong(open.back().place, "This [ is never closed.");
}

bool ModuleReader::arguments(ModuleTree& module) {
  if (!on_sign('(')) return true;
  const SourceLocation opened = here();
  ++at_;
  if (on_sign(')')) return ++at_, true;
  for (;;) {
    if (!expression_before(end_, module.arguments.emplace_back())) return false;
    if (module.arguments.size() > most_parameters) return too_many_parameters(opened);
    if (at_ >= end_) return wrong(opened, "This ( is never closed.");
    if (tokens_[at_++].is(')')) return true;
  }
}

}  // namespace panicle::lsystem
