#include "models/flower/syntax/reader.hpp"

#include <algorithm>

#include "expression/dialect_hints.hpp"
#include "expression/number_text.hpp"
#include "foundation/random.hpp"

namespace panicle::flower {
namespace {

using expression::Expression;
using expression::Node;
using expression::SourceLocation;
using expression::Token;
using expression::TokenKind;

constexpr std::size_t most_labels = 4000, most_modules = 256;
constexpr std::string_view final_step = "finalStep";
constexpr const char* directives =
    "A line with # is #define NAME(…), #define name=…, #axiom: NAME, #module NAME or #material; '%' is none of these.";

bool is_axiom(const Token& token) { return token.is("axiom") || token.is("axiome"); }

}  // namespace

void FlowerReader::Uses::add(const Uses& other) {
  variables |= other.variables;
  age |= other.age;
  values |= other.values;
  locals |= other.locals;
  draws |= other.draws;
}

FlowerReader::FlowerReader(std::span<const Token> tokens, Program& program, expression::Lowering& lowering)
    : TokenReader(tokens), program_(program), lowering_(lowering), figures_(tokens.size(), Figure::unread) {
  for (const std::string_view name : field_names) formals_.push_back({name, {}});
  for (const std::string_view name : word_names) formals_.push_back({name, {}});
}

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
      if (!statement(each)) return false;
      if (at_ < end_) return wrong(here(), "'%' cannot stand here; take it out, or begin a new line.", {found()});
    }
  }
  for (const Grammar& grammar : program_.grammars)
    if (grammar.axiom == invalid)
      return wrong(grammar.name.empty() ? SourceLocation{1, 1} : grammar.place,
                   "Nothing says what %% begins with; write #axiom: and a volume's name.",
                   {grammar.name.empty() ? "the flower" : "the module ", grammar.name});
  finish();
  return true;
}

// A module's numbers are those of its first volume.
void FlowerReader::find_forms_of_modules() {
  forms_of_modules_.assign(program_.grammars.size(), Form::plain);
  for (const Statement& each : statements_) {
    if (!tokens_[each.begin].is('#') || each.begin + 3 >= each.end || !is_axiom(tokens_[each.begin + 1])) continue;
    const std::uint32_t label = labels_.find(key_of(tokens_[each.begin + 3].text, each.grammar));
    if (label != expression::Names::none) forms_of_modules_[each.grammar] = forms_[label];
  }
}

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

bool FlowerReader::begin_module(std::size_t end) {
  end_ = end;
  at_ += 2;
  if (!on_name() || at_ + 1 < end) return wrong(here(), "A module has a name: #module PETAL.");
  if (grammars_.find(found()) != expression::Names::none)
    return wrong(here(), "There is a module % already; take one out, or call it otherwise.", {found()});
  if (program_.grammars.size() > most_modules) return fail(Reason::limit, here(), "There are more than 256 modules.");
  grammars_.add(found());
  Grammar& grammar = program_.grammars.emplace_back();
  grammar.name = std::string(found());
  grammar.place = here();
  return true;
}

// A statement continues in the next line within brackets, and where something has to follow.
std::size_t FlowerReader::statement_end(std::size_t begin) const {
  std::size_t open = 0;
  for (std::size_t at = begin; at < tokens_.size(); ++at) {
    const Token& token = tokens_[at];
    if (at > begin && token.first_on_line && open == 0) {
      const Token& before = tokens_[at - 1];
      const bool goes_on = !token.is('#') && (before.kind == TokenKind::arrow || token.kind == TokenKind::arrow ||
                                              before.is(',') || before.is('|') || before.is('<') || before.is(':') ||
                                              token.is('[') || token.is('{') || token.is(':') || token.is('|'));
      if (!goes_on) return at;
    }
    if (token.is('(') || token.is('{') || token.is('[')) ++open;
    if ((token.is(')') || token.is('}') || token.is(']')) && open > 0) --open;
  }
  return tokens_.size();
}

bool FlowerReader::declare(const Statement& statement) {
  at_ = statement.begin;
  end_ = statement.end;
  grammar_ = statement.grammar;
  if (!on_sign('#')) return true;
  ++at_;
  if (on_name() && (is_axiom(tokens_[at_]) || found() == "material")) return true;
  if (!on_name() || found() != "define") return wrong(here(), directives, {found()});
  ++at_;
  if (!on_name()) return wrong(here(), "A name is expected here, as in #define STEM(8, 0, 0, 0, 1, 1, 1, 1).");
  return next_is(at_, '=') ? declare_variable(statement) : declare_volume(statement);
}

bool FlowerReader::declare_volume(const Statement& statement) {
  const SourceLocation place = here();
  const std::string key = key_of(found(), statement.grammar);
  if (labels_.find(key) != expression::Names::none)
    return wrong(place, "There is a volume % already; take one out, or call it otherwise.", {found()});
  if (program_.labels.size() == most_labels) return fail(Reason::limit, place, "There are more than 4000 volumes.");
  if (at_ + 1 < end_ && !opens(at_ + 1))
    return wrong(tokens_[at_ + 1].place, "A volume has % behind its name, a variable = and its value.",
                 {numbers_of_volume});
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

bool FlowerReader::declare_variable(const Statement& statement) {
  const std::string_view name = found();
  if (name == final_step) return true;
  if (is_reserved(name)) return wrong(here(), "% has a meaning of its own here; call the variable otherwise.", {name});
  const std::string key = key_of(name, statement.grammar);
  if (variables_.find(key) != expression::Names::none)
    return wrong(here(), "% has been given a value already; take one out.", {name});
  if (program_.variables.size() == most_variables)
    return fail(Reason::limit, here(), "There are more than 1000 variables.");
  variables_.add(key);
  Variable& variable = program_.variables.emplace_back();
  variable.name = std::string(name);
  variable.grammar = statement.grammar;
  variable.to = lowering_.define(key);
  expression::Range& all = program_.grammars[statement.grammar].variables;
  if (all.end == 0) all.begin = static_cast<std::uint32_t>(program_.variables.size() - 1);
  all.end = static_cast<std::uint32_t>(program_.variables.size());
  keys_of_variables_.push_back(spelled_.emplace_back(key));
  uses_of_variables_.emplace_back();
  definitions_.push_back(statement);
  return true;
}

bool FlowerReader::statement(const Statement&) {
  if (!on_sign('#')) return production();
  ++at_;
  if (is_axiom(tokens_[at_])) return axiom();
  if (found() == "material") return material();
  ++at_;
  return definition();
}

bool FlowerReader::definition() { return next_is(at_, '=') ? variable() : volume(); }

bool FlowerReader::volume() {
  const std::uint32_t at = find_label(found());
  Label& label = program_.labels[at];
  const SourceLocation place = here();
  ++at_;
  if (at_ == end_) {
    program_.notes.push_back(expression::sentence(
        "% is defined without numbers: it has as many sides as the face that it grows on, and is 1 mm in all "
        "directions.",
        {label.name}));
    return true;
  }
  lowering_.begin_production(formals_, hash_combine(hash_text("volume"), next_key()));
  label.description.place = place;
  return description(forms_[at], Scope::description, label.description);
}

bool FlowerReader::variable() {
  const std::string_view name = found();
  const SourceLocation place = here();
  at_ += 2;
  if (at_ == end_) return wrong(here(), "A value is missing here, as in #define %=7.", {name});
  lowering_.begin_production(formals_, hash_combine(hash_text("variable"), next_key()));
  Grammar& grammar = program_.grammars[grammar_];
  if (name == final_step) {
    if (grammar.final_step.value.given) return wrong(place, "finalStep has been given already; take one out.");
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

// `#axiom: STEM`, or `#axiom: STEM(12, …)`
bool FlowerReader::axiom() {
  Grammar& grammar = program_.grammars[grammar_];
  if (grammar.axiom != invalid) return wrong(here(), "What it begins with has been said already; take one out.");
  ++at_;
  if (!expect(':', "A colon is expected here, as in #axiom: STEM.")) return false;
  if (!label_named(grammar.axiom)) return false;
  lowering_.begin_production(formals_, hash_combine(hash_text("axiom"), next_key()));
  return description(forms_[grammar.axiom], Scope::description, grammar.axiom_arguments);
}

// Finds the comma or the ) that ends the current entry.
bool FlowerReader::entry_end(std::size_t& end) const {
  std::size_t open = 0;
  for (end = at_; end < end_; ++end) {
    const Token& token = tokens_[end];
    if (open == 0 && (token.is(',') || token.is(')'))) return true;
    open += token.is('(') || token.is('[');
    open -= (token.is(')') || token.is(']')) && open > 0;
  }
  return false;
}

bool FlowerReader::description(Form form, Scope scope, Description& description) {
  const std::uint32_t begin = lowering_.here();
  description.code = {begin, begin};
  if (!opens(at_)) return true;
  const SourceLocation opened = here();
  if (description.place.line == 0) description.place = opened;
  std::vector<std::pair<std::size_t, std::size_t>> entries;
  ++at_;
  for (;;) {
    std::size_t end = at_;
    if (!entry_end(end)) return wrong(opened, "This ( is never closed.");
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
    if (!nothing)
      return wrong(tokens_[first].place, "There are ten numbers here, one more than a volume has: %.",
                   {numbers_of_volume});
    program_.notes.push_back(
        expression::sentence("Line %: ten numbers are one angle too many; the sixth, which is 0, is passed over.",
                             {std::to_string(opened.line)}));
    entries.erase(entries.begin() + 5);
  }
  if (entries.size() > fields)
    return wrong(opened, "A volume has eight numbers, %, or nine with T behind N; here are %.",
                 {numbers_of_volume, std::to_string(entries.size())});
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

bool FlowerReader::number(std::size_t end, Scope scope, bool of_map, Number& number, Uses* used) {
  for (std::size_t at = at_; at < end; ++at)
    if (figures_[at] == Figure::unread) figures_[at] = Figure::free;
  if (of_map) pin_figures(at_, end);
  if (!knows_functions(end)) return false;
  Expression tree;
  const std::size_t whole = end_;
  end_ = end;
  const bool read = expression_to(end, tree);
  end_ = whole;
  if (!read) return false;
  Uses uses;
  if (!rewritten(tree, scope, uses, number.draws)) return false;
  const std::uint32_t begin = lowering_.here();
  const auto source = lowering_.lower(tree);
  if (!source) {
    trouble_ = source.error();
    return false;
  }
  number.value = {true, {begin, lowering_.here()}, source.value(), tree.place};
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
    if (!expression::foreign_function(name).empty()) continue;
    std::string known = "math.random";
    for (const expression::Function& function : expression::functions)
      if (!expression::is_space_query(function.op)) known.append(", ").append(function.name);
    return fail(Reason::undefined, tokens_[at].place, "There is no function '%'; there are %.", {name, known});
  }
  return true;
}

// Replaces names by the variables of this grammar, or of the text.
bool FlowerReader::rewritten(Expression& tree, Scope scope, Uses& uses, bool& draws) {
  for (Node& node : tree.nodes) {
    if (node.kind == Node::Kind::element)
      return wrong(node.place, "There are no lists in a flower's grammar; numbers stand in round brackets.");
    if (node.kind == Node::Kind::operation && expression::is_space_query(node.op))
      return wrong(node.place,
                   "% asks about a place of the plant, which a flower's grammar does not know; take it out.",
                   {node.name});
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
        return wrong(node.place,
                     "A variable has one value, and % is another from volume to volume; use it in a production.",
                     {node.name});
      uses.age |= is_age;
      uses.values |= formal < fields;
      continue;
    }
    uses.variables.set(variable);
    node.name = keys_of_variables_[variable];
  }
  return true;
}

bool FlowerReader::unknown(const Node& node, Scope scope) {
  if (scope == Scope::variable)
    return fail(Reason::undefined, node.place, "Nothing above this line gives % a value; add #define %=… before it.",
                {node.name, node.name});
  return fail(Reason::undefined, node.place,
              "There is no '%' here; add #define %=…, or use step, finalStep, face, age, along, beside or a number of "
              "the volume "
              "that it grows from (N, T, atx, aty, atz, H, L, W, m).",
              {node.name, node.name});
}

void FlowerReader::mark_rebuilding(const Uses& uses) {
  rebuilding_ |= uses.variables;
  program_.age_rebuilds |= uses.age;
  program_.values_rebuild |= uses.values;
  program_.draws_rebuild |= uses.draws;
  if (uses.locals) {
    Uses of_blocks = of_blocks_;
    of_blocks.locals = false;
    mark_rebuilding(of_blocks);
    pin_figures(read_.begin, read_.end);
  }
}

void FlowerReader::pin_figures(std::size_t begin, std::size_t end) {
  std::fill(figures_.begin() + static_cast<std::ptrdiff_t>(begin), figures_.begin() + static_cast<std::ptrdiff_t>(end),
            Figure::pinned);
}

// Lines are part of the key, since notes name them.
void FlowerReader::append_structure_key() {
  for (std::size_t i = 0; i < definitions_.size(); ++i)
    if (program_.variables[i].rebuilds) pin_figures(definitions_[i].begin, definitions_[i].end);
  for (const auto& [variable, statement] : calls_)
    if (program_.variables[variable].rebuilds) pin_figures(statement.begin, statement.end);
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

std::string FlowerReader::key_of(std::string_view name, std::uint32_t grammar) const {
  return (program_.grammars[grammar].name + ':').append(name);
}

std::uint32_t FlowerReader::find_label(std::string_view name) const {
  const std::uint32_t found = labels_.find(key_of(name, grammar_));
  return found == expression::Names::none ? invalid : found;
}

std::uint32_t FlowerReader::find_variable(std::string_view name, std::uint32_t grammar) const {
  std::uint32_t found = variables_.find(key_of(name, grammar));
  if (found == expression::Names::none) found = variables_.find(key_of(name, 0));
  return found == expression::Names::none ? invalid : found;
}

std::uint32_t FlowerReader::find_grammar(std::string_view name) const {
  const std::uint32_t found = grammars_.find(name);
  return found == expression::Names::none || found == 0 ? invalid : found;
}

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
    expression::Range& of = program_.labels[program_.productions[i].predecessor].productions;
    if (of.end == 0) of.begin = i;
    of.end = i + 1;
  }
  note_unreached();
  for (const Renamed& each : renamed_) {
    const Label& to = program_.labels[each.to];
    if (to.productions.size() == 0) continue;
    program_.notes.push_back(
        expression::sentence("Line %: % becomes %, whose productions then hold for it.",
                             {std::to_string(each.line), program_.labels[each.from].name, to.name}));
  }
}

}  // namespace panicle::flower
