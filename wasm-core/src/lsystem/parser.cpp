#include "lsystem/parser.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "lsystem/expression.hpp"
#include "lsystem/foreign.hpp"
#include "lsystem/names.hpp"

namespace panicle::lsystem {
namespace {

constexpr std::size_t most_neighbours = 64;

class GrammarParser {
 public:
  explicit GrammarParser(std::span<const Token> tokens) : tokens_(tokens) {}

  Result<Grammar> run() {
    while (at_ < tokens_.size())
      if (!statement()) return trouble_;
    if (grammar_.axiom.empty()) {
      fail(Reason::syntax, {1, 1}, "The grammar has no axiom; begin with a line such as axiom: A(1).");
      return trouble_;
    }
    return std::move(grammar_);
  }

 private:
  bool fail(Reason reason, const Place& place, const char* pattern, Pieces pieces = {}) {
    trouble_ = error_at(reason, place, pattern, pieces);
    return false;
  }
  bool wrong(const Place& place, const char* pattern, Pieces pieces = {}) {
    return fail(Reason::syntax, place, pattern, pieces);
  }

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

  bool is_sight(std::size_t at) const {
    return (tokens_[at].is("ignore") || tokens_[at].is("consider")) && at + 1 < tokens_.size() &&
           tokens_[at + 1].is(':') && arrow_of_line(at) == end_of_line(at);
  }

  // A line begins a statement when it begins with `#`, `axiom:`, `derivation length:`, `ignore:` or `consider:` or
  // holds an arrow; any other goes on with the one before.
  bool begins_statement(std::size_t at) const {
    return tokens_[at].is('#') || is_axiom(at) || is_length(at) || is_sight(at) || is_foreign_line(at) ||
           foreign_arrow(at) != 0 || arrow_of_line(at) < end_of_line(at);
  }

  // `Lsystem: 1`, `endlsystem` and the like. They would otherwise go on with the statement before them.
  bool is_foreign_line(std::size_t at) const {
    const std::size_t end = end_of_line(at);
    if (tokens_[at].kind != TokenKind::name || foreign_statement(tokens_[at].text).empty()) return false;
    const bool followed = at + 1 < end && (tokens_[at].is("derivation") || tokens_[at].is("maximum"));
    return arrow_of_line(at) == end && (at + 1 == end || tokens_[at + 1].is(':') || followed);
  }

  // Where `->` or `-.33->` stands in a line without an arrow; 0 where neither does.
  std::size_t foreign_arrow(std::size_t at) const {
    const std::size_t end = end_of_line(at);
    if (arrow_of_line(at) < end) return 0;
    for (++at; at + 1 < end; ++at)
      if (tokens_[at].is('-') && tokens_[at + 1].is('>') && touching(tokens_[at], tokens_[at + 1])) return at;
    return 0;
  }

  bool is_comment(std::size_t at) const {
    return at + 1 < tokens_.size() && tokens_[at].is('/') && tokens_[at + 1].is('/');
  }

  bool statement() {
    const std::size_t begin = at_;
    end_ = end_of_line(begin);
    if (tokens_[begin].is('#')) return directive();
    if (is_length(begin)) return length();
    if (is_sight(begin)) return sight();
    arrow_ = arrow_of_line(begin);
    const bool production = arrow_ < end_;
    if (!production && !is_axiom(begin)) return no_statement(begin);
    while (end_ < tokens_.size() && !begins_statement(end_)) end_ = end_of_line(end_);
    return production ? this->production() : axiom();
  }

  bool no_statement(std::size_t begin) {
    const Place& place = tokens_[begin].place;
    if (is_foreign_line(begin)) return wrong(place, "%", {foreign_statement(tokens_[begin].text)});
    if (const std::size_t arrow = foreign_arrow(begin)) {
      if (tokens_[arrow - 1].kind != TokenKind::number) return wrong(tokens_[arrow].place, "An arrow is written -->.");
      return wrong(tokens_[arrow - 1].place, "A weight stands behind the successor and a colon here: A --> B : %.",
                   {tokens_[arrow - 1].text});
    }
    if (is_comment(begin)) return wrong(place, "A comment is written /* … */ here; // is two rolls of the turtle.");
    return wrong(place,
                 "This line belongs to no statement; begin with #define, #input, #role, axiom:, derivation length:, "
                 "ignore:, consider: or a production with -->.");
  }

  bool directive() {
    ++at_;
    if (!on_name()) return wrong(here(), "A name is expected after #: define, input or role.");
    const Token& keyword = tokens_[at_++];
    if (keyword.text == "role") return role();
    const bool input = keyword.text == "input";
    if (!input && keyword.text != "define") {
      if (!foreign_directive(keyword.text).empty()) return wrong(keyword.place, "%", {foreign_directive(keyword.text)});
      return wrong(keyword.place, "There is no #%; write #define, #input or #role.", {keyword.text});
    }
    return definition(input);
  }

  bool role() {
    if (!on_name()) return wrong(here(), "A role's name is expected here, not '%'.", {found()});
    RoleTree role{tokens_[at_++].text, {}};
    while (at_ < end_) {
      Named symbol{{}, here()};
      if (!this->symbol(symbol.name)) return false;
      role.symbols.push_back(symbol);
    }
    if (role.symbols.empty())
      return wrong(here(), "Which symbols have the role '%'? Write them behind its name.", {role.name});
    grammar_.roles.push_back(std::move(role));
    return true;
  }

  bool definition(bool input) {
    if (!on_name()) return wrong(here(), "A name is expected here, not '%'.", {found()});
    DefinitionTree definition;
    definition.name = tokens_[at_].text;
    definition.place = tokens_[at_].place;
    ++at_;
    const std::uint32_t first = defined_.add(definition.name);
    if (first < grammar_.definitions.size())
      return wrong(definition.place, "'%' is defined twice, first in line %; give one of them another name.",
                   {definition.name, std::to_string(grammar_.definitions[first].place.line)});
    if (!input && on_sign('['))
      return wrong(here(), "A #define holds one number; a list is declared by #input %[] and given with the request.",
                   {definition.name});
    if (input ? !input_form(definition) : !expression_to(end_, definition.expression)) return false;
    grammar_.definitions.push_back(std::move(definition));
    return true;
  }

  bool length() {
    if (grammar_.steps.given())
      return wrong(tokens_[at_].place, "There is a second derivation length; keep one of them.");
    at_ += 3;
    return expression_to(end_, grammar_.steps);
  }

  bool sight() {
    const Token& keyword = tokens_[at_];
    SightTree& sight = grammar_.sight;
    if (sight.kind != SightTree::Kind::all)
      return wrong(keyword.place, "What contexts see is said twice; keep one line with ignore: or consider:.");
    sight.kind = keyword.is("ignore") ? SightTree::Kind::ignore : SightTree::Kind::consider;
    at_ += 2;
    while (at_ < end_) {
      Named symbol{{}, here()};
      if (!this->symbol(symbol.name)) return false;
      if (symbol.name == "[" || symbol.name == "]")
        return wrong(symbol.place, "Brackets are always seen; take '%' out of the list.", {symbol.name});
      sight.symbols.push_back(symbol);
    }
    return !sight.symbols.empty() || wrong(here(), "Which symbols? Write them behind %:.", {keyword.text});
  }

  bool input_form(DefinitionTree& definition) {
    definition.kind = Definition::Kind::input;
    if (on_sign('[')) {
      ++at_;
      if (!on_sign(']'))
        return wrong(here(), "An array is declared as #input name[], with nothing between the brackets.");
      ++at_;
      definition.kind = Definition::Kind::array;
    }
    if (at_ < end_) return wrong(here(), "Nothing may follow the name of an input, but here is '%'.", {found()});
    return true;
  }

  bool expression_before(std::size_t end, Expression& expression) {
    Result<Expression> result = parse_expression(tokens_, at_, end);
    if (!result) {
      trouble_ = result.error();
      return false;
    }
    expression = std::move(result.value());
    return true;
  }

  // An expression that reaches exactly to `end`.
  bool expression_to(std::size_t end, Expression& expression) {
    if (!expression_before(end, expression)) return false;
    return at_ == end || wrong(here(), "'%' cannot stand here; take it out.", {found()});
  }

  bool axiom() {
    if (!grammar_.axiom.empty()) return wrong(tokens_[at_].place, "There is a second axiom; keep one of them.");
    at_ += 2;
    const Place place = here();
    if (!modules(grammar_.axiom)) return false;
    if (at_ < end_) return wrong(here(), "An axiom has no weight; take out the colon.");
    return !grammar_.axiom.empty() || wrong(place, "The axiom needs at least one module, such as A(1).");
  }

  bool production() {
    ProductionTree production;
    if (is_label())
      return wrong(here(), "In cpfg '%:' labels a production; there are no labels here, so leave it out.", {found()});
    if (!predecessor(production) || !condition(production)) return false;
    at_ = arrow_ + 1;
    const std::size_t end = end_of_line(arrow_);
    for (std::size_t i = at_; i < end; ++i)
      if (tokens_[i].kind == TokenKind::arrow)
        return wrong(tokens_[i].place, "This line has a second -->; begin each production on a line of its own.");
    const bool empty = on_sign('*');  // cpfg's way to write an empty successor
    at_ += empty;
    if (!empty && !modules(production.successor)) return false;
    if (on_sign(':')) {
      ++at_;
      if (!expression_to(end_, production.weight)) return false;
    }
    if (at_ < end_) return wrong(here(), "Nothing but a weight may follow *, but here is '%'.", {found()});
    grammar_.productions.push_back(std::move(production));
    return true;
  }

  // Whether the production begins with `p1 :`. So it does when another colon follows, or when the name stands nowhere
  // else and what follows its colon is no expression.
  bool is_label() {
    if (!on_name() || at_ + 2 >= arrow_ || !tokens_[at_ + 1].is(':')) return false;
    for (std::size_t i = at_ + 2; i < arrow_; ++i)
      if (tokens_[i].is(':')) return true;
    const Token& next = tokens_[at_ + 2];
    static constexpr std::string_view never_begin_expressions = "&^/\\|[]%?";
    if (times_named(found()) > 1) return false;
    if (next.kind == TokenKind::name) return times_named(next.text) > 1 && !is_value(at_ + 2);
    if (next.is('*')) return at_ + 3 < arrow_;
    return next.kind == TokenKind::sign && never_begin_expressions.find(next.text[0]) != std::string_view::npos;
  }

  // Whether the name at `at` is a constant's or calls a function.
  bool is_value(std::size_t at) const {
    for (const Function& function : functions)
      if (tokens_[at].is(function.name)) return true;
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i)
      if (tokens_[i].is('#') && tokens_[i + 2].is(tokens_[at].text)) return true;
    return false;
  }

  // How often a name of the text stands there.
  std::uint32_t times_named(std::string_view name) {
    if (times_.empty()) {
      times_.assign(tokens_.size(), 0);
      for (const Token& token : tokens_) ++times_[words_.add(token.text)];
    }
    return times_[words_.find(name)];
  }

  // `left < predecessor > right`, up to the colon of a condition.
  bool predecessor(ProductionTree& production) {
    std::size_t end = at_;
    while (end < arrow_ && !tokens_[end].is(':')) ++end;
    const std::size_t after = std::exchange(end_, arrow_);
    std::vector<Named> beside;
    if (std::any_of(tokens_.begin() + at_, tokens_.begin() + end, [](const Token& token) { return token.is('<'); })) {
      if (!neighbours(end, '<', production.left, beside)) return false;
      if (!on_sign('<'))
        return wrong(here(), "The left context stands first, then the predecessor, then the right one: A < B > C.");
      ++at_;
    }
    production.place = here();
    if (!symbol(production.predecessor) || !formals(production.formals)) return false;
    production.arity = static_cast<std::uint32_t>(production.formals.size());
    if (on_sign('<')) return wrong(here(), "There is a second < here; a predecessor has one left context.");
    if (on_sign('>')) {
      ++at_;
      if (!neighbours(end, '>', production.right, beside)) return false;
    }
    production.formals.insert(production.formals.end(), beside.begin(), beside.end());
    if (at_ < end_ && !on_sign(':'))
      return wrong(here(), "A condition begins with a colon, but here is '%'.", {found()});
    end_ = after;
    return different(production.formals);
  }

  // The modules of a context: the left one up to its `<`, the right one up to `end`. A lone `*` is none.
  bool neighbours(std::size_t end, char side, std::vector<NeighbourTree>& neighbours, std::vector<Named>& beside) {
    if (on_sign('*')) return ++at_, true;
    const Place began = here();
    std::vector<Place> open;
    while (at_ < end && !on_sign('<') && !on_sign('>')) {
      NeighbourTree neighbour{{}, here(), 0};
      const std::size_t before = beside.size();
      if (!symbol(neighbour.name) || !formals(beside)) return false;
      neighbour.arity = static_cast<std::uint32_t>(beside.size() - before);
      const bool opens = neighbour.name == "[", closes = neighbour.name == "]";
      if (side == '<' && (opens || closes))
        return wrong(neighbour.place, "A left context is the way from the root to the module, which has no brackets.");
      if (opens) open.push_back(neighbour.place);
      if (closes && open.empty()) return wrong(neighbour.place, "This ] closes nothing.");
      if (closes) open.pop_back();
      neighbours.push_back(neighbour);
      if (neighbours.size() > most_neighbours)
        return fail(Reason::limit, neighbour.place, "A context has at most 64 modules; look less far.");
    }
    if (!open.empty()) return wrong(open.back(), "This [ is never closed.");
    if (neighbours.empty())
      return wrong(began, "A context is expected beside %; leave the sign out where there is none, or write *.",
                   {std::string_view(side == '<' ? "<" : ">")});
    return true;
  }

  bool different(const std::vector<Named>& formals) {
    if (formals.size() > most_parameters)
      return fail(Reason::limit, formals[most_parameters].place,
                  "A predecessor and its context have at most 32 parameters together; leave some modules out.");
    for (std::size_t i = 1; i < formals.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (formals[k].name == formals[i].name)
          return wrong(formals[i].place, "The parameter '%' stands here twice.", {formals[i].name});
    return true;
  }

  bool condition(ProductionTree& production) {
    if (at_ == arrow_) return true;
    ++at_;
    const bool always = at_ == arrow_ || (on_sign('*') && at_ + 1 == arrow_);
    if (always) return true;
    return expression_to(arrow_, production.condition);
  }

  // A name, a sign of the turtle or ?E.
  bool symbol(std::string_view& name) {
    static constexpr std::string_view signs = "+-&^/\\|![]%";
    if (at_ >= end_) return wrong(tokens_[arrow_].place, "A symbol is expected before -->, on the same line.");
    const Token& token = tokens_[at_];
    name = token.text;
    if (token.is('?')) {
      if (at_ + 1 < end_ && !foreign_query(tokens_[at_ + 1].text).empty())
        return wrong(token.place, "%", {foreign_query(tokens_[at_ + 1].text)});
      if (at_ + 1 >= end_ || !tokens_[at_ + 1].is("E") || !touching(token, tokens_[at_ + 1]))
        return wrong(token.place, "The only communication module is ?E; write it in one word.");
      name = {token.text.data(), 2};
      ++at_;
    } else if (token.kind != TokenKind::name && signs.find(token.text[0]) == std::string_view::npos) {
      return no_symbol(token);
    }
    ++at_;
    return true;
  }

  bool no_symbol(const Token& token) {
    if (!foreign_module(token.text).empty()) return wrong(token.place, "%", {foreign_module(token.text)});
    if (token.kind == TokenKind::number)
      return wrong(token.place, "A symbol begins with a letter; '%' cannot be one.", {token.text});
    return wrong(token.place, "'%' cannot stand in a string of modules; docs/turtle.md lists what can.", {token.text});
  }

  // Adds the names in parentheses, where there are any.
  bool formals(std::vector<Named>& formals) {
    if (!on_sign('(')) return true;
    const Place opened = here();
    const std::size_t before = formals.size();
    ++at_;
    while (!on_sign(')')) {
      if (at_ >= end_) return wrong(opened, "This ( is never closed.");
      if (formals.size() > before) {
        if (!on_sign(',')) return wrong(here(), "A comma is expected here, not '%'.", {found()});
        ++at_;
      }
      if (!on_name()) return wrong(here(), "A predecessor's parameters are names; here is '%'.", {found()});
      if (formals.size() - before == most_parameters) return too_many(opened);
      formals.push_back({tokens_[at_].text, tokens_[at_].place});
      ++at_;
    }
    ++at_;
    return true;
  }

  bool too_many(const Place& place) {
    return fail(Reason::limit, place, "A module has at most 32 parameters; split it into two.");
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
        if (open.empty()) return wrong(module.place, "This ] closes nothing.");
        open.pop_back();
      }
      modules.push_back(std::move(module));
    }
    return open.empty() || wrong(open.back(), "This [ is never closed.");
  }

  bool arguments(ModuleTree& module) {
    if (!on_sign('(')) return true;
    const Place opened = here();
    ++at_;
    if (on_sign(')')) return ++at_, true;
    for (;;) {
      if (!expression_before(end_, module.arguments.emplace_back())) return false;
      if (module.arguments.size() > most_parameters) return too_many(opened);
      if (at_ >= end_) return wrong(opened, "This ( is never closed.");
      if (tokens_[at_++].is(')')) return true;
    }
  }

  std::span<const Token> tokens_;
  std::size_t at_ = 0;
  std::size_t end_ = 0;               // of the statement
  std::size_t arrow_ = 0;             // of the production
  Names defined_;                     // in the order of the definitions
  Names words_;                       // all that stands in the text
  std::vector<std::uint32_t> times_;  // how often each word does
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
