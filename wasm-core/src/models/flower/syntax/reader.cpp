#include "models/flower/syntax/reader.hpp"

#include <algorithm>

#include "expression/dialect_hints.hpp"
#include "expression/messages.generated.hpp"
#include "expression/number_text.hpp"
#include "foundation/random.hpp"
#include "models/flower/messages.generated.hpp"

namespace panicle::flower {
namespace {

using expression::Expression;
using expression::Node;
using expression::SourceLocation;
using expression::Token;
using expression::TokenKind;

constexpr std::size_t most_labels = 4000, most_modules = 256;
constexpr std::string_view final_step = "finalStep";
// A statement continues in the next line where something has to follow.
constexpr expression::StatementSyntax syntax{"([{", [](const Token& last, const Token& next) {
                                               return !next.is('#') &&
                                                      (last.kind == TokenKind::arrow || next.kind == TokenKind::arrow ||
                                                       last.is(',') || last.is('|') || last.is('<') || last.is(':') ||
                                                       next.is('[') || next.is('{') || next.is(':') || next.is('|'));
                                             }};

// Whether a token is the word `axiom`, in English or in the French of the thesis.
bool is_axiom(const Token& token) { return token.is("axiom") || token.is("axiome"); }

}  // namespace

// Adds the dependencies of another expression.
void FlowerReader::Uses::add(const Uses& other) {
  variables |= other.variables;
  age |= other.age;
  values |= other.values;
  locals |= other.locals;
  draws |= other.draws;
}

// Prepares reading; the names of fields and words become formal parameters of all expressions.
FlowerReader::FlowerReader(std::span<const Token> tokens, Program& program, expression::Lowering& lowering)
    : StatementReader(tokens, syntax, lowering), program_(program), figures_(tokens.size(), Figure::unread) {
  for (const std::string_view name : field_names) formals_.push_back({name, {}});
  for (const std::string_view name : word_names) formals_.push_back({name, {}});
}

// Reads the whole text: splits it into statements, declares all names, then reads the variables and after them all
// other statements.
bool FlowerReader::run() {
  program_.grammars.push_back({});
  grammars_.add("");
  if (!split_statements()) return false;
  for (const Statement& each : statements_)
    if (!declare(each)) return false;
  find_forms_of_modules();
  // Variables first, since volumes and productions may use those of the text from within a module.
  for (const bool of_variables : {true, false}) {
    for (const Statement& each : statements_) {
      at_ = each.begin;
      end_ = each.end;
      grammar_ = each.grammar;
      read_ = each;
      const bool defines = tokens_[at_].is('#') && tokens_[at_ + 1].is("define") && next_is(at_ + 2, '=');
      if (defines != of_variables) continue;
      if (!statement(each) || !at_statement_end()) return false;
    }
  }
  for (const Grammar& grammar : program_.grammars)
    if (grammar.axiom == invalid)
      return wrong(grammar.name.empty() ? SourceLocation{1, 1} : grammar.place,
                   grammar.name.empty() ? message(messages::flower::no_axiom)
                                        : message(messages::flower::module_without_axiom, grammar.name));
  finish();
  return true;
}

// Determines which lists of numbers a module takes: those of its first volume.
void FlowerReader::find_forms_of_modules() {
  forms_of_modules_.assign(program_.grammars.size(), Form::plain);
  for (const Statement& each : statements_) {
    if (!tokens_[each.begin].is('#') || each.begin + 3 >= each.end || !is_axiom(tokens_[each.begin + 1])) continue;
    const std::uint32_t label = labels_.find(key_of(tokens_[each.begin + 3].text, each.grammar));
    if (label != expression::Names::none) forms_of_modules_[each.grammar] = forms_[label];
  }
}

// Divides the text into statements, each with the number of its grammar: 0 for the main one, then by module.
bool FlowerReader::split_statements() {
  end_ = tokens_.size();
  std::uint32_t grammar = 0;
  for (std::size_t at = 0; at < tokens_.size();) {
    end_ = tokens_.size();
    const std::size_t end = statement_end(at);
    at_ = at;
    if (tokens_[at].is('#') && at + 1 < end && tokens_[at + 1].is("module")) {
      if (!begin_module(end)) return false;
      grammar = static_cast<std::uint32_t>(program_.grammars.size() - 1);
    } else {
      statements_.push_back({at, end, grammar});
    }
    at = end;
  }
  return true;
}

// Reads `#module NAME`, up to `end`, and begins its grammar.
bool FlowerReader::begin_module(std::size_t end) {
  end_ = end;
  at_ += 2;
  if (!on_name() || at_ + 1 < end) return wrong(here(), message(messages::flower::module_syntax));
  if (grammars_.find(found()) != expression::Names::none)
    return wrong(here(), message(messages::flower::module_twice, found()));
  if (program_.grammars.size() > most_modules)
    return fail(Reason::limit, here(), message(messages::flower::too_many_modules));
  grammars_.add(found());
  Grammar& grammar = program_.grammars.emplace_back();
  grammar.name = std::string(found());
  grammar.place = here();
  return true;
}

// Declares the volume or variable of a `#define`; other statements declare nothing, and an unknown directive is an
// error.
bool FlowerReader::declare(const Statement& statement) {
  at_ = statement.begin;
  end_ = statement.end;
  grammar_ = statement.grammar;
  if (!on_sign('#')) return true;
  ++at_;
  if (on("axiom") || on("axiome") || on("material")) return true;
  if (!on("define")) return wrong(here(), message(messages::flower::directive_syntax, found_text()));
  ++at_;
  if (!on_name()) return wrong(here(), message(messages::flower::define_syntax));
  return next_is(at_, '=') ? declare_variable(statement) : declare_volume(statement);
}

// Declares a volume by its `#define`, before its numbers are read; counts its commas to know whether its lists have a
// translation.
bool FlowerReader::declare_volume(const Statement& statement) {
  const SourceLocation place = here();
  const std::string key = key_of(found(), statement.grammar);
  if (labels_.find(key) != expression::Names::none)
    return wrong(place, message(messages::flower::volume_twice, found()));
  if (program_.labels.size() == most_labels)
    return fail(Reason::limit, place, message(messages::flower::too_many_volumes));
  if (at_ + 1 < end_ && !opens(at_ + 1))
    return wrong(tokens_[at_ + 1].place, message(messages::flower::definition_syntax));
  labels_.add(key);
  Label& label = program_.labels.emplace_back();
  label.name = std::string(found());
  label.grammar = statement.grammar;
  label.place = place;
  std::size_t commas = 0, open = 0;
  for (std::size_t at = at_ + 1; at < end_; ++at) {
    open += tokens_[at].is('(');
    open -= tokens_[at].is(')') && open > 0;
    commas += tokens_[at].is(',') && open == 1;
  }
  forms_.push_back(commas >= 8 ? Form::translated : Form::plain);
  return true;
}

// Declares a variable by its `#define`, before its value is read, so that statements above may use it.
bool FlowerReader::declare_variable(const Statement& statement) {
  const std::string_view name = found();
  if (name == final_step) return true;
  if (is_reserved(name)) return wrong(here(), message(messages::flower::reserved_name, name));
  const std::string key = key_of(name, statement.grammar);
  if (variables_.find(key) != expression::Names::none) return wrong(here(), message(messages::flower::set_twice, name));
  if (program_.variables.size() == most_variables)
    return fail(Reason::limit, here(), message(messages::flower::too_many_variables));
  variables_.add(key);
  Variable& variable = program_.variables.emplace_back();
  variable.name = std::string(name);
  variable.grammar = statement.grammar;
  variable.to = lowering_.define(key);
  expression::Range& range = program_.grammars[statement.grammar].variables;
  if (range.end == 0) range.begin = static_cast<std::uint32_t>(program_.variables.size() - 1);
  range.end = static_cast<std::uint32_t>(program_.variables.size());
  keys_of_variables_.push_back(spelled_.emplace_back(key));
  uses_of_variables_.emplace_back();
  definitions_.push_back(statement);
  return true;
}

// Reads one statement: an axiom, a material, a definition or a production.
bool FlowerReader::statement(const Statement&) {
  if (!on_sign('#')) return production();
  ++at_;
  if (is_axiom(tokens_[at_])) return axiom();
  if (found() == "material") return material();
  ++at_;
  return definition();
}

// Reads a definition of a variable or of a volume.
bool FlowerReader::definition() { return next_is(at_, '=') ? variable() : volume(); }

// Reads the numbers of a volume's definition; without them it takes its face's sides and 1 mm.
bool FlowerReader::volume() {
  const std::uint32_t at = find_label(found());
  Label& label = program_.labels[at];
  const SourceLocation place = here();
  ++at_;
  if (at_ == end_) {
    program_.notes.push_back(message(messages::flower::without_numbers, label.name));
    return true;
  }
  lowering_.begin_production(formals_, hash_combine(hash_text("volume"), next_key()));
  label.description.place = place;
  return description(forms_[at], Scope::description, label.description);
}

// Reads the value of a variable or of finalStep; only variables declared before it may be used.
bool FlowerReader::variable() {
  const std::string_view name = found();
  const SourceLocation place = here();
  at_ += 2;
  if (at_ == end_) return wrong(here(), message(messages::flower::value_missing, name));
  lowering_.begin_production(formals_, hash_combine(hash_text("variable"), next_key()));
  Grammar& grammar = program_.grammars[grammar_];
  if (name == final_step) {
    if (grammar.final_step.value.given) return wrong(place, message(messages::flower::set_twice, "finalStep"));
    known_variables_ = static_cast<std::uint32_t>(program_.variables.size());
    return number(end_, Scope::variable, true, grammar.final_step);
  }
  const std::uint32_t at = find_variable(name, grammar_);
  known_variables_ = at;
  Number& value = program_.variables[at].number;
  if (!number(end_, Scope::variable, false, value, &uses_of_variables_[at])) return false;
  program_.variables[at].needs = lowering_.once_bound();
  grammar.draws |= value.draws;
  return true;
}

// Reads an axiom, `#axiom: STEM` or `#axiom: STEM(12, …)`.
bool FlowerReader::axiom() {
  Grammar& grammar = program_.grammars[grammar_];
  if (grammar.axiom != invalid) return wrong(here(), message(messages::flower::axiom_twice));
  ++at_;
  if (!expect(':', messages::flower::axiom_syntax)) return false;
  if (!label_named(grammar.axiom)) return false;
  lowering_.begin_production(formals_, hash_combine(hash_text("axiom"), next_key()));
  return description(forms_[grammar.axiom], Scope::description, grammar.axiom_arguments);
}

// The index of the comma or bracket that ends the current entry of a list; `end_` if there is none.
std::size_t FlowerReader::entry_end() const {
  return find_outside("([", at_, end_, [](const Token& token) { return token.is(',') || token.is(')'); });
}

// Reads and compiles a list of a volume's numbers in parentheses, if there is one. Entries may be empty; lists of 8
// have no translation, those of 9 do, others by the `form`.
bool FlowerReader::description(Form form, Scope scope, Description& description) {
  const std::uint32_t begin = lowering_.here();
  description.code = {begin, begin};
  if (!opens(at_)) return true;
  const SourceLocation opened = here();
  if (description.place.line == 0) description.place = opened;
  std::vector<std::pair<std::size_t, std::size_t>> entries;
  ++at_;
  for (;;) {
    const std::size_t end = entry_end();
    if (end == end_) return never_closed(opened);
    entries.push_back({at_, end});
    at_ = end;
    if (on_sign(')')) break;
    ++at_;
  }
  const std::size_t behind = at_ + 1;
  if (entries.size() == 1 && entries[0].first == entries[0].second) entries.clear();
  // The thesis's Table 3 has ten numbers of a petal, of which one angle is too many.
  if (entries.size() == 10) {
    const auto [first, end] = entries[5];
    const bool nothing =
        first == end || (end == first + 1 && tokens_[first].kind == TokenKind::number && tokens_[first].number == 0);
    if (!nothing) return wrong(tokens_[first].place, message(messages::flower::ten_numbers));
    program_.notes.push_back(
        message(messages::expression::at_line, opened.line, message(messages::flower::sixth_ignored)));
    entries.erase(entries.begin() + 5);
  }
  if (entries.size() > fields) return wrong(opened, message(messages::flower::volume_numbers, entries.size()));
  const bool translated = entries.size() == 9 || (entries.size() != 8 && form == Form::translated);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    auto [first, end] = entries[i];
    if (first == end) continue;
    // <math.random(0, rd)>
    if (tokens_[first].is('<') && end > first + 2 && tokens_[end - 1].is('>')) ++first, --end;
    const std::size_t field = i + (i > 0 && !translated);
    Number number;
    at_ = first;
    if (!this->number(end, scope, field == 0, number)) return false;
    description.sources[field] = number.value.source;
    description.places[field] = number.value.place;
    description.given = static_cast<std::uint16_t>(description.given | 1u << field);
  }
  at_ = behind;
  description.code.end = lowering_.here();
  return true;
}

// Reads and compiles an expression up to `end`. `of_map`: the map depends on it; `used`, unless null, becomes its
// dependencies.
bool FlowerReader::number(std::size_t end, Scope scope, bool of_map, Number& number, Uses* used) {
  for (std::size_t at = at_; at < end; ++at)
    if (figures_[at] == Figure::unread) figures_[at] = Figure::free;
  if (of_map) pin_numbers(at_, end);
  if (!knows_functions(end)) return false;
  Expression tree;
  const std::size_t whole = end_;
  end_ = end;
  const bool read = expression_to(end, tree);
  end_ = whole;
  if (!read) return false;
  Uses uses;
  if (!rewritten(tree, scope, uses, number.draws)) return false;
  if (!compile(tree, number.value)) return false;
  if (of_map) mark_rebuilding(uses);
  if (used != nullptr) *used = uses;
  return true;
}

// Whether all called functions up to `end` exist.
bool FlowerReader::knows_functions(std::size_t end) {
  for (std::size_t at = at_; at + 1 < end; ++at) {
    const std::string_view name = tokens_[at].text;
    if (tokens_[at].kind != TokenKind::name || !tokens_[at + 1].is('(')) continue;
    const auto is_called = [&](const expression::Function& function) { return function.name == name; };
    if (std::any_of(expression::functions.begin(), expression::functions.end(), is_called)) continue;
    // The expression reader has a message of its own for these.
    if (expression::foreign_function(name) != nullptr) continue;
    return fail(Reason::undefined, tokens_[at].place,
                message(messages::flower::unknown_function, name, expression::known_functions("math.random")));
  }
  return true;
}

// Replaces names by the variables of this grammar, or of the text, and records the dependencies of the expression: in
// `uses`, and in `draws` whether it has random values. Returns false with the error in `trouble()`.
bool FlowerReader::rewritten(Expression& tree, Scope scope, Uses& uses, bool& draws) {
  for (Node& node : tree.nodes) {
    if (node.kind == Node::Kind::element) return wrong(node.place, message(messages::flower::no_arrays));
    if (node.kind == Node::Kind::operation && expression::is_space_query(node.op))
      return wrong(node.place, message(messages::flower::no_space_queries, node.name));
    draws |= node.kind == Node::Kind::operation && expression::is_random(node.op);
    uses.draws |= draws;
    // Some bounds are refused, which is known only when the value is drawn.
    program_.values_rebuild |= node.kind == Node::Kind::operation && node.op == expression::Op::random_whole;
    if (node.kind != Node::Kind::name) continue;
    if (std::find(locals_.begin(), locals_.end(), node.name) != locals_.end() && scope == Scope::production) {
      uses.locals = true;
      continue;
    }
    // A variable of the text hides a number of the volume with the same name.
    std::uint32_t variable = find_variable(node.name, grammar_);
    if (scope == Scope::variable && variable >= known_variables_) variable = find_variable(node.name, 0);
    if (variable == invalid || (scope == Scope::variable && variable >= known_variables_)) {
      std::size_t formal = 0;
      while (formal < formals_.size() && formals_[formal].name != node.name) ++formal;
      if (formal == formals_.size()) return unknown(node, scope);
      const bool is_age = formal == static_cast<std::size_t>(Word::age);
      if (scope == Scope::variable && !is_age)
        return wrong(node.place, message(messages::flower::not_constant, node.name));
      uses.age |= is_age;
      uses.values |= formal < fields;
      continue;
    }
    uses.variables.set(variable);
    node.name = keys_of_variables_[variable];
  }
  return true;
}

// Fails with the message for an undefined name.
bool FlowerReader::unknown(const Node& node, Scope scope) {
  if (scope == Scope::variable)
    return fail(Reason::undefined, node.place, message(messages::flower::undefined_variable, node.name));
  return fail(Reason::undefined, node.place, message(messages::flower::undefined_name, node.name));
}

// Records that the map depends on these parts of a plant. Names that blocks set depend on the names that the blocks use
// and on the numbers in the present statement.
void FlowerReader::mark_rebuilding(const Uses& uses) {
  rebuilding_ |= uses.variables;
  program_.age_rebuilds |= uses.age;
  program_.values_rebuild |= uses.values;
  program_.draws_rebuild |= uses.draws;
  if (uses.locals) {
    Uses of_blocks = of_blocks_;
    of_blocks.locals = false;
    mark_rebuilding(of_blocks);
    pin_numbers(read_.begin, read_.end);
  }
}

// Marks the number tokens in a range as part of the structure key: the map depends on them.
void FlowerReader::pin_numbers(std::size_t begin, std::size_t end) {
  std::fill(figures_.begin() + static_cast<std::ptrdiff_t>(begin), figures_.begin() + static_cast<std::ptrdiff_t>(end),
            Figure::pinned);
}

// Writes the key by which same_map compares texts: all tokens but those of materials, with 0 in place of figures that
// the map does not depend on. Lines are part of the key, since notes name them.
void FlowerReader::append_structure_key() {
  for (std::size_t i = 0; i < definitions_.size(); ++i)
    if (program_.variables[i].rebuilds) pin_numbers(definitions_[i].begin, definitions_[i].end);
  for (const auto& [variable, statement] : calls_)
    if (program_.variables[variable].rebuilds) pin_numbers(statement.begin, statement.end);
  program_.structure_key.reserve(5 * tokens_.size());
  std::uint32_t grammar = 0;
  for (const Statement& each : statements_) {
    for (; grammar < each.grammar; ++grammar)
      program_.structure_key.append("\n#module ").append(program_.grammars[grammar + 1].name);
    if (tokens_[each.begin].is('#') && tokens_[each.begin + 1].is("material")) continue;
    for (std::size_t at = each.begin; at < each.end; ++at) {
      const Token& token = tokens_[at];
      if (at == each.begin || token.first_on_line)
        program_.structure_key.append("\n").append(std::to_string(token.place.line));
      program_.structure_key += ' ';
      const bool is_free = token.kind == TokenKind::number && figures_[at] == Figure::free;
      program_.structure_key.append(is_free ? std::string_view("0") : token.text);
    }
  }
  // The length of variables' code counts as work, and figures may change it: equal terms are compiled once.
  const auto add = [&](const expression::Value& value) {
    program_.structure_key.append(" ").append(std::to_string(value.code.size()));
  };
  program_.structure_key += '\n';
  for (const Grammar& each : program_.grammars) add(each.final_step.value);
  for (const Variable& variable : program_.variables) add(variable.number.value);
  for (const Production& production : program_.productions)
    for (const GrowAction& growth : production.growths)
      for (const Setting& setting : growth.settings) add(setting.value);
}

// The name of a symbol with its grammar, unique in the text.
std::string FlowerReader::key_of(std::string_view name, std::uint32_t grammar) const {
  return (program_.grammars[grammar].name + ':').append(name);
}

// The index of a label by its name; `invalid` if there is none.
std::uint32_t FlowerReader::find_label(std::string_view name) const {
  const std::uint32_t found = labels_.find(key_of(name, grammar_));
  return found == expression::Names::none ? invalid : found;
}

// The index of a variable of a module, `grammar`, or else of the whole text, which is grammar 0; `invalid` if there is
// none of that name.
std::uint32_t FlowerReader::find_variable(std::string_view name, std::uint32_t grammar) const {
  std::uint32_t found = variables_.find(key_of(name, grammar));
  if (found == expression::Names::none) found = variables_.find(key_of(name, 0));
  return found == expression::Names::none ? invalid : found;
}

// The index of a module's grammar by its name; `invalid` if there is none.
std::uint32_t FlowerReader::find_grammar(std::string_view name) const {
  const std::uint32_t found = grammars_.find(name);
  return found == expression::Names::none || found == 0 ? invalid : found;
}

// Completes the program when all statements are read: which variables change the structure, the ranges of productions
// by predecessor, and the notes.
void FlowerReader::finish() {
  // A variable that depends on others, or is given by a call, passes its dependence on to those. Calls may come in any
  // order, so this repeats until nothing changes.
  std::bitset<most_variables> gone_into;
  while (gone_into != rebuilding_) {
    for (std::size_t i = program_.variables.size(); i-- > 0;) {
      if (!rebuilding_[i] || gone_into[i]) continue;
      gone_into.set(i);
      Uses uses = uses_of_variables_[i];
      // `variables()` has the values of the text's variables, also where they are drawn.
      uses.draws &= program_.variables[i].grammar != 0;
      mark_rebuilding(uses);
    }
  }
  for (std::size_t i = 0; i < program_.variables.size(); ++i) program_.variables[i].rebuilds = rebuilding_[i];
  append_structure_key();
  std::stable_sort(program_.productions.begin(), program_.productions.end(),
                   [](const Production& a, const Production& b) { return a.predecessor < b.predecessor; });
  for (std::uint32_t i = 0; i < program_.productions.size(); ++i) {
    expression::Range& range = program_.labels[program_.productions[i].predecessor].productions;
    if (range.end == 0) range.begin = i;
    range.end = i + 1;
  }
  note_unreached();
  for (const Renamed& each : renamed_) {
    const Label& to = program_.labels[each.to];
    if (to.productions.size() == 0) continue;
    program_.notes.push_back(message(messages::expression::at_line, each.line,
                                     message(messages::flower::renamed, program_.labels[each.from].name, to.name)));
  }
}

}  // namespace panicle::flower
