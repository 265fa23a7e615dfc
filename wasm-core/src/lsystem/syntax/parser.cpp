#include "lsystem/syntax/parser.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "expression/dialect_hints.hpp"
#include "expression/messages.generated.hpp"
#include "lsystem/messages.generated.hpp"
#include "lsystem/syntax/production_reader.hpp"

namespace panicle::lsystem {

// The turtle is the moving pen that draws a string; homomorphism rules replace modules while the string is drawn,
// without changing it.

namespace {

constexpr std::size_t max_points = 256;  // of a curve

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

// Parser of the text of an L-system. The is_… methods test if a kind of statement begins at a token; the others read
// one and return false with the error in `trouble_`.
class GrammarParser : public ProductionReader {
 public:
  GrammarParser(std::span<const Token> tokens, Notation notation) : ProductionReader(tokens) {
    grammar_.notation = notation;
  }

  // Parses the whole text.
  Result<Grammar> run() {
    join_lines();
    if (!find_systems()) return trouble_;
    while (at_ < tokens_.size())
      if (!statement()) return trouble_;
    if (grammar_.axiom.empty()) {
      fail(Reason::syntax, {1, 1}, message(messages::lsystem::no_axiom));
      return trouble_;
    }
    return std::move(grammar_);
  }

 private:
  // Whether a sign follows the token.
  bool follows(std::size_t at, char sign) const { return at + 1 < tokens_.size() && tokens_[at + 1].is(sign); }
  // Whether a token is the last one on its line.
  bool ends_line(std::size_t at) const { return end_of_line(at) == at + 1; }

  // Whether `axiom:` is at a token.
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

  // Whether `derivation length:` begins here.
  bool is_length(std::size_t at) const {
    static constexpr std::string_view words[] = {"derivation", "length"};
    return is_line(at, words);
  }
  // Whether `maximum depth:` begins here.
  bool is_depth(std::size_t at) const {
    static constexpr std::string_view words[] = {"maximum", "depth"};
    return is_line(at, words);
  }

  // Whether `ignore:` or `consider:` begins here, the filter of contexts.
  bool is_sight(std::size_t at) const {
    return (tokens_[at].is_keyword("ignore") || tokens_[at].is_keyword("consider")) && follows(at, ':') &&
           arrow_of_line(at) == end_of_line(at);
  }

  // The kind of setting that begins here, or null.
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
    return named && (ends_line(at) || (follows(at, ':') && (ends_line(at + 1) || has_statement)));
  }

  // Whether `lsystem:` or `endlsystem` begins here.
  bool is_system(std::size_t at) const {
    return (tokens_[at].is_keyword("lsystem") && follows(at, ':')) ||
           (tokens_[at].is_keyword("endlsystem") && ends_line(at));
  }

  // A line begins a statement when it begins with `#` and a directive, with the words of another statement, or contains
  // an arrow; any other continues the one before.
  bool begins_statement(std::size_t at) {
    return is_directive(at) || is_axiom(at) || is_length(at) || is_depth(at) || is_sight(at) || is_section(at) ||
           is_system(at) || setting_line(at) != nullptr || is_foreign_line(at) || is_unknown_line(at) ||
           foreign_arrow(at) != none || is_assignment(at) || (tokens_[at].is('#') && is_comment(at)) ||
           arrow_of_line(at) < end_of_line(at);
  }

  // Whether `#` begins a directive: a name follows it without a space (`#define`), or one of these names with a space
  // (`# define`), or nothing follows on its line, which is reported later. Any other `#` is the turtle's symbol.
  bool is_directive(std::size_t at) const {
    if (!tokens_[at].is('#')) return false;
    if (ends_line(at)) return true;
    static constexpr std::string_view directives[] = {"define", "input", "role", "curve", "turtle"};
    const Token& next = tokens_[at + 1];
    return next.kind == TokenKind::name &&
           (touching(tokens_[at], next) ||
            std::find(std::begin(directives), std::end(directives), next.text) != std::end(directives));
  }

  // Lines of other programs such as `seed: 1`. They would otherwise continue the statement before them.
  bool is_foreign_line(std::size_t at) const {
    const std::size_t end = end_of_line(at);
    if (tokens_[at].kind != TokenKind::name || foreign_statement(tokens_[at].text) == nullptr) return false;
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

  // Whether a line begins with words and an adjacent colon, and has no arrow.
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

  // Collects the symbols of all strings of modules.
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

  // Whether a token is a \ at the end of its line.
  bool ends_line_in_backslash(std::size_t at) const {
    return tokens_[at].is('\\') && at + 1 < tokens_.size() && tokens_[at + 1].first_on_line;
  }

  // Whether a comment of another program begins here: `// words`, or `# words` of which the first is not a directive.
  bool is_comment(std::size_t at) const {
    if (at + 1 >= tokens_.size()) return false;
    const bool words =
        at + 2 < end_of_line(at) && tokens_[at + 1].kind == TokenKind::name && tokens_[at + 2].kind == TokenKind::name;
    return tokens_[at].is('#') ? words : tokens_[at].is('/') && tokens_[at + 1].is('/');
  }

  // Collects the names of all L-systems of the text, which may follow `?`; they must be known before it is read. The
  // first L-system is the text itself if there are no productions before it.
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
        return wrong(tokens_[at].place, message(messages::lsystem::part_without_name));
      if (systems_.find(tokens_[at + 2].text) != Names::none)
        return wrong(tokens_[at + 2].place, message(messages::lsystem::part_twice, tokens_[at + 2].text));
      systems_.add(tokens_[at + 2].text);
      grammar_.systems.push_back(tokens_[at + 2].text);
    }
    return true;
  }

  // Reads the statement that begins here, with the lines that continue it.
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

  // Whether a line begins with an arrow, and the error of such a line.
  bool begins_with_arrow(std::size_t at) const { return at < tokens_.size() && tokens_[at].kind == TokenKind::arrow; }

  // Sets the error for an arrow at the beginning of a line; returns false.
  bool arrow_alone(std::size_t at) { return wrong(tokens_[at].place, message(messages::lsystem::arrow_on_next_line)); }

  // Reports a line that begins no statement, with advice if it is a statement of another program.
  bool no_statement(std::size_t begin) {
    const SourceLocation& place = tokens_[begin].place;
    if (is_foreign_line(begin)) return wrong(place, message(*foreign_statement(tokens_[begin].text)));
    if (const Hint hint = foreign_label(tokens_[begin].text); hint && is_unknown_line(begin))
      return wrong(place, message(*hint));
    if (is_assignment(begin)) {
      const std::string_view name = tokens_[begin].text;
      if (const Hint hint = foreign_statement(name)) return wrong(place, message(*hint));
      if (const Hint hint = foreign_label(name)) return wrong(place, message(*hint));
      return wrong(place, message(messages::lsystem::define_syntax, name));
    }
    if (const std::size_t arrow = foreign_arrow(begin); arrow != none) {
      if (arrow == begin || tokens_[arrow - 1].kind != TokenKind::number)
        return wrong(tokens_[arrow].place, message(messages::lsystem::arrow_syntax));
      return wrong(tokens_[arrow - 1].place, message(messages::lsystem::weight_syntax, tokens_[arrow - 1].text));
    }
    if (is_comment(begin)) return wrong(place, message(messages::expression::comment_syntax));
    return wrong(place, message(messages::lsystem::unknown_statement));
  }

  // Reads a statement that begins with #.
  bool directive() {
    ++at_;
    if (!on_name()) return wrong(here(), message(messages::lsystem::directive_expected));
    const Token& keyword = tokens_[at_++];
    if (keyword.text == "role") return role();
    if (keyword.text == "curve") return curve();
    if (keyword.text == "turtle") return notation();
    if (keyword.text == "numbers") return numbers();
    const bool input = keyword.text == "input";
    if (!input && keyword.text != "define") {
      if (const Hint hint = foreign_directive(keyword.text)) return wrong(keyword.place, message(*hint));
      return wrong(keyword.place, message(messages::lsystem::unknown_directive, keyword.text));
    }
    return definition(input);
  }

  // Reads `#turtle huang` or `#turtle cpfg`: the meaning of turtle symbols.
  bool notation() {
    const bool huang = at_ < end_ && tokens_[at_].is("huang");
    if (!huang && !(at_ < end_ && tokens_[at_].is("cpfg")))
      return wrong(here(), message(messages::lsystem::turtle_syntax, found_text()));
    if (std::exchange(has_notation_, true))
      return wrong(here(), message(messages::lsystem::statement_twice, "#turtle"));
    grammar_.notation = huang ? Notation::huang : Notation::cpfg;
    ++at_;
    return at_ == end_ || wrong(here(), message(messages::expression::unexpected, found_text()));
  }

  // Reads the precision of numbers, `#numbers double` or `single`.
  bool numbers() {
    const bool doubles = at_ < end_ && tokens_[at_].is("double");
    if (!doubles && !(at_ < end_ && tokens_[at_].is("single")))
      return wrong(here(), message(messages::lsystem::numbers_syntax, found_text()));
    if (std::exchange(has_precision_, true))
      return wrong(here(), message(messages::lsystem::statement_twice, "#numbers"));
    grammar_.doubles = doubles;
    ++at_;
    return at_ == end_ || wrong(here(), message(messages::expression::unexpected, found_text()));
  }

  // Reads `#role name symbols`.
  bool role() {
    if (!on_name()) return wrong(here(), message(messages::lsystem::role_name_expected, found_text()));
    RoleTree role{tokens_[at_++].text, {}};
    while (at_ < end_) {
      Named symbol{{}, here()};
      if (!this->symbol(symbol.name)) return false;
      role.symbols.push_back(symbol);
    }
    if (role.symbols.empty()) return wrong(here(), message(messages::lsystem::role_without_symbols, role.name));
    grammar_.roles.push_back(std::move(role));
    return true;
  }

  // Checks that names of #define, #input and #curve differ.
  bool new_name(const Named& name) {
    const std::uint32_t first = defined_.add(name.name);
    if (first == places_.size()) return places_.push_back(name.place), true;
    return wrong(name.place, message(messages::lsystem::defined_twice, name.name, places_[first].line));
  }

  // Reads `#define name expression`, an array, a macro, or `#input name`.
  bool definition(bool input) {
    if (!on_name()) return wrong(here(), message(messages::lsystem::name_expected, found_text()));
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
      return input ? wrong(here(), message(messages::lsystem::after_input, found_text()))
                   : macro(definition.name, definition.place);
    if (on_sign('[')) {
      ++at_;
      if (!expect(']', messages::lsystem::array_syntax)) return false;
      definition.kind = Definition::Kind::array;
    }
    if (input) {
      if (at_ < end_) return wrong(here(), message(messages::lsystem::after_input, found_text()));
    } else if (definition.kind == Definition::Kind::array) {
      if (!list(definition.values)) return false;
    } else if (!expression_to(end_, definition.values.emplace_back())) {
      return false;
    }
    grammar_.definitions.push_back(std::move(definition));
    return true;
  }

  // Reads a macro, `#define name(formals) body`.
  bool macro(std::string_view name, const SourceLocation& place) {
    Macro macro;
    for (const Function& function : functions)
      if (function.name == name) return wrong(place, message(messages::lsystem::function_twice, name));
    if (!formals(macro.formals) || !are_valid(macro.formals) || !expression_to(end_, macro.body)) return false;
    macros_.names.add(name);
    macros_.all.push_back(std::move(macro));
    return true;
  }

  // Reads the values of an array, `1, 2, 3` or `{1, 2, 3}`, up to the end of the line.
  bool list(std::vector<Expression>& values) {
    const bool braces = on_sign('{');
    at_ += braces;
    for (;;) {
      if (!expression_before(end_, values.emplace_back())) return false;
      if (!on_sign(',')) break;
      ++at_;
    }
    if (braces && !expect('}')) return false;
    return at_ == end_ || wrong(here(), message(messages::lsystem::values_need_commas, found_text()));
  }

  // Reads `#curve name (x, y) (x, y) …`, a function through points.
  bool curve() {
    if (!on_name()) return wrong(here(), message(messages::lsystem::name_expected, found_text()));
    CurveTree curve{tokens_[at_].text, tokens_[at_].place, {}};
    ++at_;
    for (const Function& function : functions)
      if (function.name == curve.name)
        return wrong(curve.place, message(messages::lsystem::function_twice, curve.name));
    if (!new_name({curve.name, curve.place})) return false;
    while (at_ < end_)
      if (!point(curve)) return false;
    if (curve.points.size() < 4) return wrong(curve.place, message(messages::lsystem::curve_too_short, curve.name));
    curves_.add(curve.name);
    grammar_.curves.push_back(std::move(curve));
    return true;
  }

  // Reads a point of a curve; its x must be greater than the last one's.
  bool point(CurveTree& curve) {
    const SourceLocation place = here();
    float x = 0, y = 0;
    if (!expect('(', messages::lsystem::point_expected) || !number(x) || !expect(',') || !number(y) || !expect(')'))
      return false;
    const std::vector<float>& points = curve.points;
    if (!points.empty() && !(x > points[points.size() - 2]))
      return wrong(place, message(messages::lsystem::curve_not_ascending));
    if (points.size() == 2 * max_points) return fail(Reason::limit, place, message(messages::lsystem::curve_too_long));
    curve.points.push_back(x);
    curve.points.push_back(y);
    return true;
  }

  // Reads a number with an optional sign.
  bool number(float& value) {
    const bool minus = on_sign('-');
    at_ += minus;
    if (at_ >= end_ || tokens_[at_].kind != TokenKind::number)
      return wrong(here(), message(messages::lsystem::number_expected, found_text()));
    value = minus ? -tokens_[at_].number : tokens_[at_].number;
    ++at_;
    return true;
  }

  // Reads a line of a global setting.
  bool setting(const SettingLine& line) {
    Expression* const values = &grammar_.settings[static_cast<std::size_t>(line.first)];
    if (values->given()) return wrong(tokens_[at_].place, message(messages::lsystem::setting_twice));
    while (!tokens_[at_++].is(':')) continue;
    for (std::size_t i = 0; i < line.values; ++i) {
      if (i > 0 && !expect(',', messages::lsystem::tropism_syntax)) return false;
      if (!expression_before(end_, values[i])) return false;
    }
    return at_ == end_ || wrong(here(), message(messages::expression::unexpected, found_text()));
  }

  // Reads `derivation length: n`, the number of steps.
  bool length() {
    if (grammar_.steps.given())
      return wrong(tokens_[at_].place, message(messages::lsystem::statement_twice, "derivation length"));
    at_ += 3;
    return expression_to(end_, grammar_.steps);
  }

  // Reads `maximum depth: n`, of the section's recursion.
  bool depth() {
    if (purpose_ == Purpose::derivation)
      return wrong(tokens_[at_].place, message(messages::lsystem::depth_without_section));
    Expression& depth = grammar_.depths[static_cast<std::size_t>(purpose_) - 1];
    if (depth.given()) return wrong(tokens_[at_].place, message(messages::lsystem::setting_twice));
    at_ += 3;
    return expression_to(end_, depth);
  }

  // Begins a section: the purpose of the productions that follow.
  bool section() {
    purpose_ = tokens_[at_].is_keyword("decomposition")  ? Purpose::decomposition
               : tokens_[at_].is_keyword("homomorphism") ? Purpose::homomorphism
                                                         : Purpose::derivation;
    at_ += ends_line(at_) ? 1 : 2;
    return at_ == end_ || wrong(here(), message(messages::lsystem::after_section, found_text()));
  }

  // Begins or ends an L-system with symbols of its own.
  bool system() {
    const std::uint32_t found = tokens_[at_].is_keyword("endlsystem") || at_ == first_system_
                                    ? Names::none
                                    : systems_.find(tokens_[at_ + 2].text);
    system_ = found == Names::none ? 0 : found + 1;
    purpose_ = Purpose::derivation;
    at_ = end_;
    return true;
  }

  // Reads `ignore:` or `consider:`, the symbols that contexts skip or see.
  bool sight() {
    const Token& keyword = tokens_[at_];
    ContextFilterTree& sight = grammar_.sight;
    if (sight.kind != ContextFilterTree::Kind::all)
      return wrong(keyword.place, message(messages::lsystem::filter_twice));
    sight.kind = keyword.is_keyword("ignore") ? ContextFilterTree::Kind::ignore : ContextFilterTree::Kind::consider;
    at_ += 2;
    while (at_ < end_) {
      Named symbol{{}, here()};
      if (!this->symbol(symbol.name)) return false;
      if (symbol.name == "[" || symbol.name == "]")
        return wrong(symbol.place, message(messages::lsystem::filter_of_brackets, symbol.name));
      sight.symbols.push_back(symbol);
    }
    return !sight.symbols.empty() || wrong(here(), message(messages::lsystem::filter_without_symbols, keyword.text));
  }

  // Reads `axiom: modules`.
  bool axiom() {
    if (!grammar_.axiom.empty()) return wrong(tokens_[at_].place, message(messages::lsystem::statement_twice, "axiom"));
    if (system_ != 0)
      return wrong(tokens_[at_].place, message(messages::lsystem::axiom_in_part, grammar_.systems[system_]));
    at_ += 2;
    const SourceLocation place = here();
    if (!modules(grammar_.axiom)) return false;
    if (at_ < end_) return wrong(here(), message(messages::lsystem::axiom_with_weight));
    return !grammar_.axiom.empty() || wrong(place, message(messages::lsystem::axiom_empty));
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // Whether the text, or else the request, sets cpfg's notation.
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

// Reads the text of an L-system into a tree; the first error ends it.
Result<Grammar> parse(std::string_view text, Notation notation) {
  const Result<std::vector<Token>> tokens = tokenize(text);
  if (!tokens) return tokens.error();
  return GrammarParser(tokens.value(), notation).run();
}

}  // namespace panicle::lsystem
