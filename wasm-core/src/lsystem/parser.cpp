#include "lsystem/parser.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "lsystem/expression.hpp"

namespace panicle::lsystem {
namespace {

// First words of statements of cpfg that mean nothing here. They would otherwise go on with the statement before them.
bool is_foreign(std::string_view name) {
  static constexpr std::string_view foreign[] = {
      "lsystem", "Lsystem", "endlsystem", "derivation", "decomposition", "homomorphism", "consider", "ignore", "seed"};
  return std::find(std::begin(foreign), std::end(foreign), name) != std::end(foreign);
}

class GrammarParser {
 public:
  explicit GrammarParser(std::span<const Token> tokens) : tokens_(tokens) {}

  Result<Grammar> run() {
    while (at_ < tokens_.size())
      if (!statement()) return trouble_;
    if (grammar_.axiom.empty()) {
      fail(Reason::syntax, {1, 1}, {"The grammar has no axiom; begin with a line such as axiom: A(1)."});
      return trouble_;
    }
    return std::move(grammar_);
  }

 private:
  bool fail(Reason reason, const Place& place, Pieces pieces) {
    trouble_ = error_at(reason, place, pieces);
    return false;
  }
  bool wrong(const Place& place, Pieces pieces) { return fail(Reason::syntax, place, pieces); }

  Place here() const { return place_of(tokens_, at_, end_); }
  bool on_sign(char sign) const { return at_ < end_ && tokens_[at_].is(sign); }
  bool on_name() const { return at_ < end_ && tokens_[at_].kind == TokenKind::name; }
  std::string_view found() const { return at_ < end_ ? tokens_[at_].text : std::string_view("the end"); }

  std::size_t end_of_line(std::size_t at) const {
    do ++at;
    while (at < tokens_.size() && !tokens_[at].first_on_line);
    return at;
  }

  // The first arrow of the line that begins at `at`, or the line's end.
  std::size_t arrow_of_line(std::size_t at) const {
    const std::size_t end = end_of_line(at);
    while (at < end && tokens_[at].kind != TokenKind::arrow) ++at;
    return at;
  }

  bool is_axiom(std::size_t at) const {
    return tokens_[at].is("axiom") && at + 1 < tokens_.size() && tokens_[at + 1].is(':');
  }

  bool is_length(std::size_t at) const {
    return tokens_[at].is("derivation") && at + 2 < tokens_.size() && tokens_[at + 1].is("length") &&
           tokens_[at + 2].is(':');
  }

  // A line begins a statement when it begins with `#`, `axiom:` or `derivation length:` or holds an arrow; any other
  // goes on with the one before.
  bool begins_statement(std::size_t at) const {
    return tokens_[at].is('#') || is_axiom(at) || is_foreign_line(at) || arrow_of_line(at) < end_of_line(at);
  }

  // `derivation length: 5`, `endlsystem` and the like.
  bool is_foreign_line(std::size_t at) const {
    const std::size_t end = end_of_line(at);
    if (tokens_[at].kind != TokenKind::name || !is_foreign(tokens_[at].text) || arrow_of_line(at) < end) return false;
    return at + 1 == end || tokens_[at + 1].is(':') || tokens_[at].is("derivation");
  }

  bool statement() {
    const std::size_t begin = at_;
    end_ = end_of_line(begin);
    if (tokens_[begin].is('#')) return directive();
    if (is_length(begin)) return length();
    arrow_ = arrow_of_line(begin);
    const bool production = arrow_ < end_;
    if (!production && !is_axiom(begin)) {
      if (is_foreign_line(begin))
        return wrong(tokens_[begin].place, {"'", tokens_[begin].text,
                                            "' is a statement of cpfg that means nothing here; leave the line out."});
      return wrong(tokens_[begin].place,
                   {"This line belongs to no statement; begin with #define, #input, axiom: or a production with -->."});
    }
    while (end_ < tokens_.size() && !begins_statement(end_)) end_ = end_of_line(end_);
    return production ? this->production() : axiom();
  }

  bool directive() {
    ++at_;
    if (!on_name()) return wrong(here(), {"A name is expected after #: define or input."});
    const Token& keyword = tokens_[at_++];
    const bool input = keyword.text == "input";
    if (!input && keyword.text != "define")
      return wrong(keyword.place, {"There is no #", keyword.text, "; write #define or #input."});
    if (!on_name()) return wrong(here(), {"A name is expected here, not '", found(), "'."});
    DefinitionTree definition;
    definition.name = tokens_[at_].text;
    definition.place = tokens_[at_].place;
    ++at_;
    const auto [first, added] = defined_.try_emplace(definition.name, definition.place.line);
    if (!added)
      return wrong(definition.place, {"'", definition.name, "' is defined twice, first in line ",
                                      std::to_string(first->second), "; give one of them another name."});
    if (input ? !input_form(definition) : !expression_to(end_, definition.expression)) return false;
    grammar_.definitions.push_back(std::move(definition));
    return true;
  }

  bool length() {
    if (grammar_.steps) return wrong(tokens_[at_].place, {"There is a second derivation length; keep one of them."});
    at_ += 3;
    grammar_.steps.emplace();
    return expression_to(end_, *grammar_.steps);
  }

  bool input_form(DefinitionTree& definition) {
    definition.kind = Definition::Kind::input;
    if (on_sign('[')) {
      ++at_;
      if (!on_sign(']'))
        return wrong(here(), {"An array is declared as #input name[], with nothing between the brackets."});
      ++at_;
      definition.kind = Definition::Kind::array;
    }
    if (at_ < end_) return wrong(here(), {"Nothing may follow the name of an input, but here is '", found(), "'."});
    return true;
  }

  // An expression that reaches exactly to `end`.
  bool expression_to(std::size_t end, Expression& expression) {
    Result<Expression> result = parse_expression(tokens_, at_, end);
    if (!result) {
      trouble_ = result.error();
      return false;
    }
    if (at_ < end) return wrong(here(), {"'", found(), "' cannot stand here; take it out."});
    expression = std::move(result.value());
    return true;
  }

  bool axiom() {
    if (!grammar_.axiom.empty()) return wrong(tokens_[at_].place, {"There is a second axiom; keep one of them."});
    at_ += 2;
    const Place place = here();
    if (!modules(grammar_.axiom)) return false;
    if (at_ < end_) return wrong(here(), {"An axiom has no weight; take out the colon."});
    return !grammar_.axiom.empty() || wrong(place, {"The axiom needs at least one module, such as A(1)."});
  }

  bool production() {
    ProductionTree production;
    if (!predecessor(production) || !condition(production)) return false;
    at_ = arrow_ + 1;
    const std::size_t end = end_of_line(arrow_);
    for (std::size_t i = at_; i < end; ++i)
      if (tokens_[i].kind == TokenKind::arrow)
        return wrong(tokens_[i].place, {"This line has a second -->; begin each production on a line of its own."});
    const bool empty = on_sign('*');  // cpfg's way to write an empty successor
    at_ += empty;
    if (!empty && !modules(production.successor)) return false;
    if (on_sign(':')) {
      ++at_;
      Expression weight;
      if (!expression_to(end_, weight)) return false;
      production.weight = std::move(weight);
    }
    if (at_ < end_) return wrong(here(), {"Nothing but a weight may follow *, but here is '", found(), "'."});
    grammar_.productions.push_back(std::move(production));
    return true;
  }

  bool predecessor(ProductionTree& production) {
    const std::size_t end = std::exchange(end_, arrow_);
    production.place = here();
    if (!symbol(production.predecessor) || !formals(production.formals)) return false;
    if (at_ < end_ && !on_sign(':')) {
      if (on_sign('<') || on_sign('>'))
        return wrong(here(), {"Productions cannot see their neighbours here; take out what stands beside < or >."});
      return wrong(here(), {"A condition begins with a colon, but here is '", found(), "'."});
    }
    end_ = end;
    return true;
  }

  bool condition(ProductionTree& production) {
    if (at_ == arrow_) return true;
    ++at_;
    const bool always = at_ == arrow_ || (on_sign('*') && at_ + 1 == arrow_);
    if (always) return true;
    Expression condition;
    if (!expression_to(arrow_, condition)) return false;
    production.condition = std::move(condition);
    return true;
  }

  // A name, a sign of the turtle or ?E.
  bool symbol(std::string_view& name) {
    static constexpr std::string_view signs = "+-&^/\\|![]%";
    if (at_ >= end_) return wrong(tokens_[arrow_].place, {"A symbol is expected before -->, on the same line."});
    const Token& token = tokens_[at_];
    name = token.text;
    if (token.is('?')) {
      if (at_ + 1 >= end_ || !tokens_[at_ + 1].is("E") || !touching(token, tokens_[at_ + 1]))
        return wrong(token.place, {"The only communication module is ?E; write it in one word."});
      name = {token.text.data(), 2};
      ++at_;
    } else if (token.kind != TokenKind::name && signs.find(token.text[0]) == std::string_view::npos) {
      return wrong(token.place,
                   {"'", token.text, "' cannot stand in a string of modules; docs/turtle.md lists what can."});
    }
    ++at_;
    return true;
  }

  bool formals(std::vector<Formal>& formals) {
    if (!on_sign('(')) return true;
    const Place opened = here();
    ++at_;
    while (!on_sign(')')) {
      if (at_ >= end_) return wrong(opened, {"This ( is never closed."});
      if (!formals.empty()) {
        if (!on_sign(',')) return wrong(here(), {"A comma is expected here, not '", found(), "'."});
        ++at_;
      }
      if (!on_name()) return wrong(here(), {"A predecessor's parameters are names; here is '", found(), "'."});
      for (const Formal& earlier : formals)
        if (earlier.name == found()) return wrong(here(), {"The parameter '", found(), "' stands here twice."});
      if (formals.size() == most_parameters) return too_many(opened);
      formals.push_back({tokens_[at_].text, tokens_[at_].place});
      ++at_;
    }
    ++at_;
    return true;
  }

  bool too_many(const Place& place) {
    return fail(Reason::limit, place, {"A module has at most 32 parameters; split it into two."});
  }

  // Modules up to a `:` or the statement's end, their brackets balanced.
  bool modules(std::vector<ModuleTree>& modules) {
    std::vector<Place> open;
    while (at_ < end_ && !on_sign(':')) {
      ModuleTree module;
      module.place = here();
      if (!symbol(module.name) || !arguments(module)) return false;
      if (module.name == "[") open.push_back(module.place);
      if (module.name == "]") {
        if (open.empty()) return wrong(module.place, {"This ] closes nothing."});
        open.pop_back();
      }
      modules.push_back(std::move(module));
    }
    return open.empty() || wrong(open.back(), {"This [ is never closed."});
  }

  bool arguments(ModuleTree& module) {
    if (!on_sign('(')) return true;
    const Place opened = here();
    ++at_;
    if (on_sign(')')) return ++at_, true;
    for (;;) {
      Result<Expression> argument = parse_expression(tokens_, at_, end_);
      if (!argument) {
        trouble_ = argument.error();
        return false;
      }
      module.arguments.push_back(std::move(argument.value()));
      if (module.arguments.size() > most_parameters) return too_many(opened);
      if (at_ >= end_) return wrong(opened, {"This ( is never closed."});
      if (tokens_[at_++].is(')')) return true;
    }
  }

  std::span<const Token> tokens_;
  std::size_t at_ = 0;
  std::size_t end_ = 0;                                // of the statement
  std::size_t arrow_ = 0;                              // of the production
  std::map<std::string_view, std::uint32_t> defined_;  // name → line
  Grammar grammar_;
  Diagnostic trouble_;
};

}  // namespace

Result<Grammar> parse(std::string_view text) {
  const Result<std::vector<Token>> tokens = tokenize(text);
  if (!tokens) return tokens.error();
  return GrammarParser(tokens.value()).run();
}

}  // namespace panicle::lsystem
