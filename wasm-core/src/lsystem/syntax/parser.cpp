#include "lsystem/syntax/parser.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "expression/dialect_hints.hpp"
#include "lsystem/syntax/production_reader.hpp"

namespace panicle::lsystem {
namespace {

constexpr std::size_t most_points = 256;  // of a curve

// A line of a global setting, by its words up to the colon.
struct SettingLine {
  std::array<std::string_view, 3> words;
  GlobalSetting first;
  std::size_t values;
};
constexpr SettingLine setting_lines[] = {{{"angle", "increment", ""}, GlobalSetting::angle_increment, 1},
                                         {{"line", "length", ""}, GlobalSetting::line_length, 1},
                                         {{"line", "width", ""}, GlobalSetting::line_width, 1},
                                         {{"line", "width", "increment"}, GlobalSetting::line_width_increment, 1},
                                         {{"tropism", "", ""}, GlobalSetting::tropism_x, 4}};

class GrammarParser : public ProductionReader {
 public:
  GrammarParser(std::span<const Token> tokens, Notation notation) : ProductionReader(tokens) {
    grammar_.notation = notation;
  }

  Result<Grammar> run() {
    join_lines();
    if (!find_systems()) return trouble_;
    while (at_ < tokens_.size())
      if (!statement()) return trouble_;
    if (grammar_.axiom.empty()) {
      fail(Reason::syntax, {1, 1}, "The grammar has no axiom; begin with a line such as axiom: A(1).");
      return trouble_;
    }
    return std::move(grammar_);
  }

 private:
  bool follows(std::size_t at, char sign) const { return at + 1 < tokens_.size() && tokens_[at + 1].is(sign); }
  bool is_alone(std::size_t at) const { return end_of_line(at) == at + 1; }

  bool is_axiom(std::size_t at) const { return tokens_[at].is_keyword("axiom") && follows(at, ':'); }

  // Whether the words are at `at`, followed by a colon.
  bool is_line(std::size_t at, std::span<const std::string_view> words) const {
    for (const std::string_view word : words) {
      if (word.empty()) break;
      if (at >= tokens_.size() || !tokens_[at].is_keyword(word)) return false;
      ++at;
    }
    return at < tokens_.size() && tokens_[at].is(':');
  }

  bool is_length(std::size_t at) const {
    static constexpr std::string_view words[] = {"derivation", "length"};
    return is_line(at, words);
  }
  bool is_depth(std::size_t at) const {
    static constexpr std::string_view words[] = {"maximum", "depth"};
    return is_line(at, words);
  }

  bool is_sight(std::size_t at) const {
    return (tokens_[at].is_keyword("ignore") || tokens_[at].is_keyword("consider")) && follows(at, ':') &&
           arrow_of_line(at) == end_of_line(at);
  }

  const SettingLine* setting_line(std::size_t at) const {
    for (const SettingLine& line : setting_lines)
      if (is_line(at, line.words) && arrow_of_line(at) == end_of_line(at)) return &line;
    return nullptr;
  }

  // `decomposition`, `homomorphism` or `derivation`, alone or with a colon.
  bool is_section(std::size_t at) const {
    const bool named = tokens_[at].is_keyword("decomposition") || tokens_[at].is_keyword("homomorphism") ||
                       tokens_[at].is_keyword("derivation");
    const bool has_statement = !tokens_[at].is_keyword("derivation") && arrow_of_line(at) == end_of_line(at);
    return named && (is_alone(at) || (follows(at, ':') && (is_alone(at + 1) || has_statement)));
  }

  bool is_system(std::size_t at) const {
    return (tokens_[at].is_keyword("lsystem") && follows(at, ':')) ||
           (tokens_[at].is_keyword("endlsystem") && is_alone(at));
  }

  // A line begins a statement when it begins with `#` and a directive, with the words of another statement, or contains
  // an arrow; any other continues the one before.
  bool begins_statement(std::size_t at) {
    return is_directive(at) || is_axiom(at) || is_length(at) || is_depth(at) || is_sight(at) || is_section(at) ||
           is_system(at) || setting_line(at) != nullptr || is_foreign_line(at) || is_unknown_line(at) ||
           foreign_arrow(at) != none || is_assignment(at) || (tokens_[at].is('#') && is_comment(at)) ||
           arrow_of_line(at) < end_of_line(at);
  }

  // A directive such as `#define`; the turtle's # is no part of a longer word.
  bool is_directive(std::size_t at) const {
    if (!tokens_[at].is('#')) return false;
    if (is_alone(at)) return true;
    static constexpr std::string_view words[] = {"define", "input", "role", "curve", "turtle"};
    const Token& next = tokens_[at + 1];
    return next.kind == TokenKind::name &&
           (touching(tokens_[at], next) || std::find(std::begin(words), std::end(words), next.text) != std::end(words));
  }

  // Lines of other programs such as `seed: 1`. They would otherwise continue the statement before them.
  bool is_foreign_line(std::size_t at) const {
    const std::size_t end = end_of_line(at);
    if (tokens_[at].kind != TokenKind::name || foreign_statement(tokens_[at].text).empty()) return false;
    const bool followed = at + 1 < end && (tokens_[at].is_keyword("derivation") || tokens_[at].is_keyword("maximum") ||
                                           (at + 2 == end && tokens_[at + 1].kind == TokenKind::number));
    const bool has_value = at + 1 < end && (tokens_[at + 1].is(':') || (tokens_[at + 1].is('=') && at + 3 == end));
    return arrow_of_line(at) == end && (at + 1 == end || has_value || followed);
  }

  // Words with an adjacent colon, none of which is a symbol: `iterations: 3` would otherwise continue the statement
  // before it as modules and their weight.
  bool is_unknown_line(std::size_t at) {
    if (!is_label_of_line(at)) return false;
    for (; tokens_[at].kind == TokenKind::name; ++at)
      if (is_symbol(tokens_[at].text)) return false;
    return true;
  }

  bool is_label_of_line(std::size_t at) const {
    const std::size_t end = end_of_line(at);
    std::size_t colon = at;
    while (colon < end && tokens_[colon].kind == TokenKind::name) ++colon;
    return colon > at && colon < end && tokens_[colon].is(':') && touching(tokens_[colon - 1], tokens_[colon]) &&
           arrow_of_line(at) == end;
  }

  // Whether a name is the turtle's or occurs among modules somewhere in the text, not counting such lines.
  bool is_symbol(std::string_view name) {
    if (!strung_known_) find_symbols();
    return is_turtles(name) || string_symbols_.find(name) != Names::none;
  }

  void find_symbols() {
    strung_known_ = true;
    for (std::size_t at = 0; at < tokens_.size(); at = end_of_line(at))
      if (!tokens_[at].is('#') && (is_axiom(at) || !is_label_of_line(at))) find_symbols_of_line(at);
  }

  // Collects symbols outside of parentheses, conditions and weights.
  void find_symbols_of_line(std::size_t at) {
    std::uint32_t open = 0;
    bool among_modules = true;
    for (const std::size_t end = end_of_line(at), begin = at; at < end; ++at) {
      if (tokens_[at].is('(')) ++open;
      if (tokens_[at].is(')') && open > 0) --open;
      if (tokens_[at].is(':')) among_modules = is_axiom(begin) && at == begin + 1;
      if (tokens_[at].kind == TokenKind::arrow) among_modules = true;
      if (open == 0 && among_modules && tokens_[at].kind == TokenKind::name) string_symbols_.add(tokens_[at].text);
    }
  }

  // An assignment such as `n = 5`, which no string of modules contains.
  bool is_assignment(std::size_t at) const {
    const std::size_t end = end_of_line(at), value = at + 2 + (at + 2 < end && tokens_[at + 2].is('-'));
    return tokens_[at].kind == TokenKind::name && value < end && tokens_[at + 1].is('=') &&
           tokens_[value].kind == TokenKind::number && arrow_of_line(at) == end;
  }

  // The place of `->`, `=>`, `:=` or `-.33->` in a line without an arrow; `none` without one.
  std::size_t foreign_arrow(std::size_t at) const {
    const std::size_t end = end_of_line(at);
    if (arrow_of_line(at) < end) return none;
    for (; at + 1 < end; ++at) {
      const bool drawn = (tokens_[at].is('-') || tokens_[at].is('=')) && tokens_[at + 1].is('>');
      if ((drawn || (tokens_[at].is(':') && tokens_[at + 1].is('='))) && touching(tokens_[at], tokens_[at + 1]))
        return at;
    }
    return none;
  }

  // Joins lines that end in \. In a string of modules \ is a roll as well: there it joins lines only under cpfg's
  // turtle, and where the next line begins no statement.
  void join_lines() {
    std::size_t last = 0;
    while (last + 1 < tokens_.size() && !ends_line_in_backslash(last)) ++last;
    if (last + 1 >= tokens_.size()) return;
    std::vector<Token> joined;
    const bool cpfg = is_cpfg();
    bool among = false;  // modules, where a line begins
    for (std::size_t at = 0; at < tokens_.size();) {
      if (begins_statement(at)) among = is_axiom(at);
      std::size_t open = 0;
      const std::size_t axiom = is_axiom(at) ? at + 1 : none, line = joined.size();
      for (bool whole = false; !whole;) {
        const std::size_t end = end_of_line(at);
        const std::size_t begin = joined.size();
        for (; at < end; ++at) {
          if (tokens_[at].kind == TokenKind::arrow) among = true, open = 0;
          if (tokens_[at].is(':')) among = at == axiom;
          if (tokens_[at].is('(')) ++open;
          if (tokens_[at].is(')') && open > 0) --open;
          joined.push_back(tokens_[at]);
        }
        joined[begin].first_on_line = begin == line;
        whole = !ends_line_in_backslash(end - 1);
        if (!whole && among && open == 0 && !begins_with_arrow(end)) whole = !cpfg || begins_statement(end);
        if (!whole) joined.pop_back();
      }
    }
    joined_ = std::move(joined);
    tokens_ = joined_;
    strung_known_ = false;
    string_symbols_ = {};
  }

  bool ends_line_in_backslash(std::size_t at) const {
    return tokens_[at].is('\\') && at + 1 < tokens_.size() && tokens_[at + 1].first_on_line;
  }

  // `// words`, or `# words` of which the first is no directive.
  bool is_comment(std::size_t at) const {
    if (at + 1 >= tokens_.size()) return false;
    const bool words =
        at + 2 < end_of_line(at) && tokens_[at + 1].kind == TokenKind::name && tokens_[at + 2].kind == TokenKind::name;
    return tokens_[at].is('#') ? words : tokens_[at].is('/') && tokens_[at + 1].is('/');
  }

  // The names that may follow `?` must be known before the text is read. The first L-system is the text itself where it
  // has no productions before it.
  bool find_systems() {
    bool grows = false;
    for (std::size_t at = 0; at < tokens_.size(); at = end_of_line(at)) {
      grows |= is_axiom(at) || arrow_of_line(at) < end_of_line(at);
      if (!is_system(at) || tokens_[at].is_keyword("endlsystem")) continue;
      end_ = end_of_line(at);
      if (!std::exchange(grows, true)) {
        first_system_ = at;
        continue;
      }
      if (at + 2 >= end_ || tokens_[at + 2].kind != TokenKind::name || at + 3 < end_)
        return wrong(tokens_[at].place,
                     "Every L-system but the first needs a name, Lsystem: leaf; what belongs to it stands behind "
                     "?leaf(1) in brackets.");
      if (systems_.find(tokens_[at + 2].text) != Names::none)
        return wrong(tokens_[at + 2].place, "There is an Lsystem: % already; give this one another name.",
                     {tokens_[at + 2].text});
      systems_.add(tokens_[at + 2].text);
      grammar_.systems.push_back(tokens_[at + 2].text);
    }
    return true;
  }

  bool statement() {
    const std::size_t begin = at_;
    end_ = end_of_line(begin);
    if (begins_with_arrow(end_) && arrow_of_line(begin) == end_) return arrow_alone(end_);
    if (is_directive(begin)) return directive();
    if (is_length(begin)) return length();
    if (is_depth(begin)) return depth();
    if (is_sight(begin)) return sight();
    if (is_section(begin)) return section();
    if (is_system(begin)) return system();
    if (const SettingLine* const line = setting_line(begin)) return setting(*line);
    arrow_ = arrow_of_line(begin);
    const bool production = arrow_ < end_;
    if (!production && !is_axiom(begin)) return no_statement(begin);
    while (end_ < tokens_.size() && !begins_statement(end_)) end_ = end_of_line(end_);
    if (begins_with_arrow(end_)) return arrow_alone(end_);
    return production ? this->production(purpose_) : axiom();
  }

  bool begins_with_arrow(std::size_t at) const { return at < tokens_.size() && tokens_[at].kind == TokenKind::arrow; }

  bool arrow_alone(std::size_t at) {
    return wrong(tokens_[at].place,
                 "An arrow stands on the line of its predecessor; move --> to the end of the line before.");
  }

  bool no_statement(std::size_t begin) {
    const SourceLocation& place = tokens_[begin].place;
    if (is_foreign_line(begin)) return wrong(place, "%", {foreign_statement(tokens_[begin].text)});
    if (is_unknown_line(begin) && !foreign_label(tokens_[begin].text).empty())
      return wrong(place, "%", {foreign_label(tokens_[begin].text)});
    if (is_assignment(begin)) {
      const std::string_view name = tokens_[begin].text;
      if (!foreign_statement(name).empty()) return wrong(place, "%", {foreign_statement(name)});
      if (!foreign_label(name).empty()) return wrong(place, "%", {foreign_label(name)});
      return wrong(place, "A constant is written #define % and its value, without =.", {name});
    }
    if (const std::size_t arrow = foreign_arrow(begin); arrow != none) {
      if (arrow == begin || tokens_[arrow - 1].kind != TokenKind::number)
        return wrong(tokens_[arrow].place, "An arrow is written -->.");
      return wrong(tokens_[arrow - 1].place, "A weight stands behind the successor and a colon here: A --> B : %.",
                   {tokens_[arrow - 1].text});
    }
    if (is_comment(begin)) return wrong(place, "A comment is written /* … */ here; // is two rolls of the turtle.");
    return wrong(place,
                 "This line belongs to no statement; begin with #define, #input, #role, #curve, #turtle, axiom:, "
                 "derivation length:, ignore:, consider:, angle increment:, line width:, tropism:, decomposition, "
                 "homomorphism or a production with -->.");
  }

  bool directive() {
    ++at_;
    if (!on_name()) return wrong(here(), "A name is expected after #: define, input, role, curve or turtle.");
    const Token& keyword = tokens_[at_++];
    if (keyword.text == "role") return role();
    if (keyword.text == "curve") return curve();
    if (keyword.text == "turtle") return notation();
    if (keyword.text == "numbers") return numbers();
    const bool input = keyword.text == "input";
    if (!input && keyword.text != "define") {
      if (!foreign_directive(keyword.text).empty()) return wrong(keyword.place, "%", {foreign_directive(keyword.text)});
      return wrong(keyword.place, "There is no #%; write #define, #input, #role, #curve, #turtle or #numbers.",
                   {keyword.text});
    }
    return definition(input);
  }

  bool notation() {
    const bool huang = at_ < end_ && tokens_[at_].is("huang");
    if (!huang && !(at_ < end_ && tokens_[at_].is("cpfg")))
      return wrong(here(), "Which turtle? #turtle cpfg turns left by +, #turtle huang right; here is '%'.", {found()});
    if (std::exchange(has_notation_, true)) return wrong(here(), "There is a second #turtle; keep one of them.");
    grammar_.notation = huang ? Notation::huang : Notation::cpfg;
    ++at_;
    return at_ == end_ || wrong(here(), "'%' cannot stand here; take it out.", {found()});
  }

  // `#numbers double`, or `single`.
  bool numbers() {
    const bool doubles = at_ < end_ && tokens_[at_].is("double");
    if (!doubles && !(at_ < end_ && tokens_[at_].is("single")))
      return wrong(
          here(),
          "#numbers needs a precision, not '%': write #numbers double, or #numbers single, which is the default.",
          {found()});
    if (std::exchange(has_precision_, true)) return wrong(here(), "There is a second #numbers; keep one of them.");
    grammar_.doubles = doubles;
    ++at_;
    return at_ == end_ || wrong(here(), "'%' cannot stand here; take it out.", {found()});
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

  // Checks that names of #define, #input and #curve differ.
  bool new_name(const Named& name) {
    const std::uint32_t first = defined_.add(name.name);
    if (first == places_.size()) return places_.push_back(name.place), true;
    return wrong(name.place, "'%' is defined twice, first in line %; give one of them another name.",
                 {name.name, std::to_string(places_[first].line)});
  }

  bool definition(bool input) {
    if (!on_name()) return wrong(here(), "A name is expected here, not '%'.", {found()});
    DefinitionTree definition;
    definition.kind = input ? Definition::Kind::input : Definition::Kind::define;
    definition.name = tokens_[at_].text;
    definition.place = tokens_[at_].place;
    ++at_;
    if (!new_name({definition.name, definition.place})) return false;
    // A number in the parentheses is no formal parameter: `f(2)*3` is 6. Nor is a name with nothing behind: `f(x)` is
    // x.
    if (on_sign('(') && touching(tokens_[at_ - 1], tokens_[at_]) && at_ + 2 < end_ &&
        tokens_[at_ + 1].kind == TokenKind::name &&
        (tokens_[at_ + 2].is(',') || (tokens_[at_ + 2].is(')') && at_ + 3 < end_)))
      return input ? wrong(here(), "Nothing may follow the name of an input, but here is '%'.", {found()})
                   : macro(definition.name, definition.place);
    if (on_sign('[')) {
      ++at_;
      if (!expect(']', "An array is declared as #input name[], with nothing between the brackets.")) return false;
      definition.kind = Definition::Kind::array;
    }
    if (input) {
      if (at_ < end_) return wrong(here(), "Nothing may follow the name of an input, but here is '%'.", {found()});
    } else if (definition.kind == Definition::Kind::array) {
      if (!list(definition.values)) return false;
    } else if (!expression_to(end_, definition.values.emplace_back())) {
      return false;
    }
    grammar_.definitions.push_back(std::move(definition));
    return true;
  }

  // `#define name(formals) body`.
  bool macro(std::string_view name, const SourceLocation& place) {
    Macro macro;
    for (const Function& function : functions)
      if (function.name == name)
        return wrong(place, "There is a function % already; give this one another name.", {name});
    if (!formals(macro.formals) || !are_valid(macro.formals) || !expression_to(end_, macro.body)) return false;
    macros_.names.add(name);
    macros_.all.push_back(std::move(macro));
    return true;
  }

  // `1, 2, 3` or `{1, 2, 3}` up to the end of the line.
  bool list(std::vector<Expression>& values) {
    const bool braces = on_sign('{');
    at_ += braces;
    for (;;) {
      if (!expression_before(end_, values.emplace_back())) return false;
      if (!on_sign(',')) break;
      ++at_;
    }
    if (braces && !expect('}', "A } is expected here, not '%'.")) return false;
    return at_ == end_ || wrong(here(), "'%' cannot stand here; put commas between the values.", {found()});
  }

  // `#curve name (x, y) (x, y) …`
  bool curve() {
    if (!on_name()) return wrong(here(), "A name is expected here, not '%'.", {found()});
    CurveTree curve{tokens_[at_].text, tokens_[at_].place, {}};
    ++at_;
    for (const Function& function : functions)
      if (function.name == curve.name)
        return wrong(curve.place, "There is a function % already; give the curve another name.", {curve.name});
    if (!new_name({curve.name, curve.place})) return false;
    while (at_ < end_)
      if (!point(curve)) return false;
    if (curve.points.size() < 4)
      return wrong(curve.place, "A curve needs at least two points: #curve % (0, 0) (1, 1).", {curve.name});
    curves_.add(curve.name);
    grammar_.curves.push_back(std::move(curve));
    return true;
  }

  bool point(CurveTree& curve) {
    const SourceLocation place = here();
    float x = 0, y = 0;
    if (!expect('(', "A point (x, y) is expected here, not '%'.") || !number(x) ||
        !expect(',', "A comma is expected here, not '%'.") || !number(y) ||
        !expect(')', "A ) is expected here, not '%'."))
      return false;
    const std::vector<float>& points = curve.points;
    if (!points.empty() && !(x > points[points.size() - 2]))
      return wrong(place, "The points of a curve go from left to right; this x is not larger than the one before.");
    if (points.size() == 2 * most_points) return fail(Reason::limit, place, "A curve has at most 256 points.");
    curve.points.push_back(x);
    curve.points.push_back(y);
    return true;
  }

  bool number(float& value) {
    const bool minus = on_sign('-');
    at_ += minus;
    if (at_ >= end_ || tokens_[at_].kind != TokenKind::number)
      return wrong(here(), "A number is expected here, not '%'.", {found()});
    value = minus ? -tokens_[at_].number : tokens_[at_].number;
    ++at_;
    return true;
  }

  bool setting(const SettingLine& line) {
    Expression* const values = &grammar_.settings[static_cast<std::size_t>(line.first)];
    if (values->given()) return wrong(tokens_[at_].place, "This is said twice; keep one of the lines.");
    while (!tokens_[at_++].is(':')) continue;
    for (std::size_t i = 0; i < line.values; ++i) {
      if (i > 0 &&
          !expect(',', line.values == 4 ? "A tropism is x, y, z and the elasticity; a comma is expected here, not '%'."
                                        : ""))
        return false;
      if (!expression_before(end_, values[i])) return false;
    }
    return at_ == end_ || wrong(here(), "'%' cannot stand here; take it out.", {found()});
  }

  bool length() {
    if (grammar_.steps.given())
      return wrong(tokens_[at_].place, "There is a second derivation length; keep one of them.");
    at_ += 3;
    return expression_to(end_, grammar_.steps);
  }

  bool depth() {
    if (purpose_ == Purpose::derivation)
      return wrong(tokens_[at_].place,
                   "A maximum depth is one of decomposition or homomorphism; put it behind that line.");
    Expression& depth = grammar_.depths[static_cast<std::size_t>(purpose_) - 1];
    if (depth.given()) return wrong(tokens_[at_].place, "This is said twice; keep one of the lines.");
    at_ += 3;
    return expression_to(end_, depth);
  }

  bool section() {
    purpose_ = tokens_[at_].is_keyword("decomposition")  ? Purpose::decomposition
               : tokens_[at_].is_keyword("homomorphism") ? Purpose::homomorphism
                                                         : Purpose::derivation;
    at_ += is_alone(at_) ? 1 : 2;
    return at_ == end_ ||
           wrong(here(), "Productions follow on lines of their own; take '%' out, which changes nothing.", {found()});
  }

  bool system() {
    const std::uint32_t found = tokens_[at_].is_keyword("endlsystem") || at_ == first_system_
                                    ? Names::none
                                    : systems_.find(tokens_[at_ + 2].text);
    system_ = found == Names::none ? 0 : found + 1;
    purpose_ = Purpose::derivation;
    at_ = end_;
    return true;
  }

  bool sight() {
    const Token& keyword = tokens_[at_];
    ContextFilterTree& sight = grammar_.sight;
    if (sight.kind != ContextFilterTree::Kind::all)
      return wrong(keyword.place, "What contexts see is said twice; keep one line with ignore: or consider:.");
    sight.kind = keyword.is_keyword("ignore") ? ContextFilterTree::Kind::ignore : ContextFilterTree::Kind::consider;
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

  bool axiom() {
    if (!grammar_.axiom.empty()) return wrong(tokens_[at_].place, "There is a second axiom; keep one of them.");
    if (system_ != 0)
      return wrong(tokens_[at_].place,
                   "Only the first L-system has an axiom; write what this one begins with behind ?% in a string.",
                   {grammar_.systems[system_]});
    at_ += 2;
    const SourceLocation place = here();
    if (!modules(grammar_.axiom)) return false;
    if (at_ < end_) return wrong(here(), "An axiom has no weight; take out the colon.");
    return !grammar_.axiom.empty() || wrong(place, "The axiom needs at least one module, such as A(1).");
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  bool is_cpfg() const {
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i)
      if (tokens_[i].first_on_line && tokens_[i].is('#') && tokens_[i + 1].is("turtle"))
        return tokens_[i + 2].is("cpfg");
    return grammar_.notation == Notation::cpfg;
  }

  std::vector<Token> joined_;  // where lines are joined
  Names defined_;              // in the order of the text
  std::vector<SourceLocation> places_;
  Names string_symbols_;  // of modules; filled on first use
  bool strung_known_ = false;
  Purpose purpose_ = Purpose::derivation;
  std::size_t first_system_ = static_cast<std::size_t>(-1);
  bool has_notation_ = false;
  bool has_precision_ = false;
};

}  // namespace

Result<Grammar> parse(std::string_view text, Notation notation) {
  const Result<std::vector<Token>> tokens = tokenize(text);
  if (!tokens) return tokens.error();
  return GrammarParser(tokens.value(), notation).run();
}

}  // namespace panicle::lsystem
