#include <algorithm>
#include <utility>

#include "expression/lowering.hpp"
#include "expression/names.hpp"
#include "expression/number_text.hpp"
#include "foundation/random.hpp"
#include "lsystem/derivation/machine.hpp"
#include "lsystem/derivation/program.hpp"
#include "lsystem/messages.generated.hpp"
#include "lsystem/syntax/parser.hpp"
#include "lsystem/syntax/remarks.hpp"
#include "lsystem/syntax/symbol_table.hpp"

namespace panicle::lsystem {

// A lineage is the address of a module and the symbols of its ancestors; the turtle is the moving pen that draws a
// string.

namespace {

constexpr std::size_t max_symbols = 0xfff0;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// Whether an expression draws random values.
bool has_random(const Expression& expression) {
  return std::any_of(expression.nodes.begin(), expression.nodes.end(),
                     [](const Node& node) { return is_random(node.op); });
}

// The same for the values of assignments, and for the arguments of modules.
bool has_random(const std::vector<AssignmentTree>& block) {
  return std::any_of(block.begin(), block.end(), [](const AssignmentTree& one) { return has_random(one.expression); });
}

bool has_random(const std::vector<ModuleTree>& modules) {
  for (const ModuleTree& module : modules)
    for (const Expression& argument : module.arguments)
      if (has_random(argument)) return true;
  return false;
}

// Whether a ?E module is among the modules.
bool has_query(const std::vector<ModuleTree>& modules) {
  return std::any_of(modules.begin(), modules.end(), [](const ModuleTree& module) { return module.name == "?E"; });
}

// Whether a program cannot do without lineages.
bool needs_lineages(const Grammar& grammar) {
  if (has_random(grammar.axiom) || has_query(grammar.axiom)) return true;
  for (const ProductionTree& production : grammar.productions) {
    if (production.weight.given() || has_query(production.successor) || has_random(production.successor)) return true;
    if (has_random(production.condition) || has_random(production.before) || has_random(production.after)) return true;
  }
  return false;
}

// Compiler of a parsed grammar into a program: registers, code, and templates of successors. Methods that return a bool
// return false with the error in `error_`.
class Compiler {
 public:
  Compiler(const Grammar& grammar, Lineages lineages)
      : grammar_(grammar),
        program_(std::make_shared<Program>()),
        lowering_(code_of(*program_, grammar)),
        symbols_(grammar, *program_) {
    program_->notation = grammar.notation;
    for (const CurveTree& curve : grammar.curves) program_->code.curves.emplace_back(curve.points);
    program_->lineages = lineages == Lineages::always || needs_lineages(grammar);
  }

  // Compiles all parts, in the order in which they depend on each other.
  Result<std::shared_ptr<const Program>> run() {
    const bool fine = declarations() && symbols() && roles() && context_filter() && axiom() && productions();
    if (!fine) return error_;
    program_->once_bound = lowering_.finish();
    program_->remarks = remarks_on(grammar_);
    program_->words.resize(program_->words.size() + block);  // room for copies in whole blocks
    return std::shared_ptr<const Program>(std::move(program_));
  }

 private:
  // The program's code, set to the precision of the grammar.
  static Code& code_of(Program& program, const Grammar& grammar) {
    program.code.doubles = grammar.doubles;
    return program.code;
  }

  bool fail(Reason reason, const SourceLocation& place, const Message& problem) {
    error_ = error_at(reason, place, problem);
    return false;
  }

  // Takes the value of a result, or its error.
  template <class Value>
  bool take(const Result<Value>& result, Value& value) {
    if (result) return value = result.value(), true;
    error_ = result.error();
    return false;
  }

  // Compiles definitions, derivation length and settings. An expression of a #define that an input replaces must still
  // be valid: undefined names in it are errors.
  bool declarations() {
    for (const DefinitionTree& definition : grammar_.definitions) {
      Declaration declaration{std::string(definition.name), definition.kind, definition.place, {}, 0};
      const bool array = definition.kind == Definition::Kind::array;
      for (const Expression& expression : definition.values)
        if (!value(expression, declaration.values.emplace_back())) return false;
      declaration.to = array ? lowering_.define_array(definition.name) : lowering_.define(definition.name);
      program_->declarations.push_back(std::move(declaration));
    }
    return value_if_given(grammar_.steps, program_->steps) && values(grammar_.settings, program_->settings) &&
           values(grammar_.depths, program_->depths);
  }

  // Compiles those expressions that are given.
  template <class Expressions, class Values>
  bool values(const Expressions& expressions, Values& values) {
    for (std::size_t i = 0; i < expressions.size(); ++i)
      if (!value_if_given(expressions[i], values[i])) return false;
    return true;
  }

  // Compiles an expression, if it is given.
  bool value_if_given(const Expression& expression, Value& value) {
    return !expression.given() || this->value(expression, value);
  }

  // Numbers all symbols.
  bool symbols() {
    symbols_.fill();
    ordinals_.assign(program_->symbols.size(), 0);
    if (program_->symbols.size() > max_symbols)
      return fail(Reason::limit, grammar_.axiom.front().place, message(messages::lsystem::too_many_symbols));
    return true;
  }

  // Assigns roles (names for groups of symbols) to symbols.
  bool roles() {
    Roles& roles = program_->roles;
    roles.of_symbol.assign(program_->symbols.size(), Roles::none);
    Names names;
    for (const RoleTree& tree : grammar_.roles) {
      const std::uint32_t role = names.add(tree.name);
      if (role == roles.names.size()) roles.names.emplace_back(tree.name);
      for (const Named& symbol : tree.symbols)
        if (!give_role(role, symbol)) return false;
    }
    return true;
  }

  // Gives a role to a symbol of the text; the turtle's symbols have none, and others one at most.
  bool give_role(std::uint32_t role, const Named& symbol) {
    Roles& roles = program_->roles;
    const std::uint32_t number = symbols_.find(symbol.name);
    if (number == Names::none)
      return fail(Reason::undefined, symbol.place, message(messages::lsystem::role_of_unknown, symbol.name));
    if (symbols_.is_turtles(number))
      return fail(Reason::syntax, symbol.place, message(messages::lsystem::role_of_turtle, symbol.name));
    std::uint32_t& given = roles.of_symbol[number];
    if (given != Roles::none && given != role)
      return fail(Reason::syntax, symbol.place,
                  message(messages::lsystem::role_twice, symbol.name, roles.names[given]));
    given = role;
    return true;
  }

  // Marks the symbols that contexts ignore.
  bool context_filter() {
    const ContextFilterTree& filter = grammar_.sight;
    const bool consider = filter.kind == ContextFilterTree::Kind::consider;
    program_->passed_over.assign(program_->symbols.size(), consider);
    Names listed;
    for (const Named& symbol : filter.symbols) {
      if (symbols_.find(symbol.name) == Names::none)
        return fail(Reason::undefined, symbol.place, message(messages::lsystem::filter_of_unknown, symbol.name));
      listed.add(symbol.name);
    }
    // Each L-system of the text may have a symbol of that name.
    for (std::uint32_t symbol = 0; symbol < program_->symbols.size(); ++symbol)
      if (listed.find(program_->symbols[symbol]) != Names::none) program_->passed_over[symbol] = !consider;
    return true;
  }

  // Compiles the axiom, like a successor.
  bool axiom() {
    lowering_.begin_production({}, hash_text("axiom"));
    return successor(grammar_.axiom, false, {}, program_->axiom);
  }

  // Compiles the productions, sorted by purpose and predecessor, those of each symbol in the order of the text.
  bool productions() {
    make_places();
    for (const ProductionTree& tree : grammar_.productions) {
      const std::uint32_t predecessor = symbols_.find(tree.predecessor, tree.system);
      if (!may_rewrite(tree, predecessor)) return false;
      Rules& rules = rules_of(tree.purpose)[predecessor];
      std::uint64_t key = rules.productions.size();
      if (tree.purpose != Purpose::derivation) key = hash_combine(static_cast<std::uint64_t>(tree.purpose), key);
      lowering_.begin_production(tree.formals, key);
      if (!production(tree, program_->productions[rules.productions.end])) return false;
      ++rules.productions.end;
      rules.weighted |= tree.weight.given();
      const Production& added = program_->productions[rules.productions.end - 1];
      rules.by_chance |= rules.weighted || added.by_chance;
      rules.in_context |= added.in_context;
      program_->in_context |= added.in_context;
      program_->looks_right |= added.right.size() > 0;
      program_->looks_far_left |= added.left.size() > 1;
    }
    return true;
  }

  // The rules by symbol of derivation, decomposition or homomorphism.
  std::vector<Rules>& rules_of(Purpose purpose) {
    return purpose == Purpose::derivation ? program_->rules : program_->rules_for[static_cast<std::size_t>(purpose)];
  }

  // Reserves places for all productions, sorted by purpose and predecessor, so that those of a symbol are a range.
  void make_places() {
    std::uint32_t first = 0;
    for (std::size_t purpose = 0; purpose < purposes; ++purpose) {
      std::vector<std::uint32_t> counts(program_->symbols.size(), 0);
      const std::uint32_t begin = first;
      for (const ProductionTree& tree : grammar_.productions)
        if (static_cast<std::size_t>(tree.purpose) == purpose)
          ++counts[symbols_.find(tree.predecessor, tree.system)], ++first;
      if (begin == first && purpose > 0) continue;
      std::uint32_t place = begin;
      for (const std::uint32_t count : counts) {
        rules_of(static_cast<Purpose>(purpose)).push_back({{place, place}, false, false, false});
        place += count;
      }
    }
    program_->productions.resize(first);
    program_->named_in.resize(first);
  }

  // Compiles a production: contexts, condition, successor, weight, and its cost in units of work.
  bool production(const ProductionTree& tree, Production& production) {
    production.predecessor = symbols_.find(tree.predecessor, tree.system);
    production.place = tree.place;
    production.arity = tree.arity;
    std::uint32_t to = tree.arity;
    if (!context(tree, tree.left, production.left, to) || !context(tree, tree.right, production.right, to))
      return false;
    set_nearest(production);
    if (production.in_context && tree.purpose != Purpose::derivation)
      return fail(Reason::syntax, tree.place, message(messages::lsystem::context_not_allowed));
    const auto place = static_cast<std::size_t>(&production - program_->productions.data());
    Range& named = program_->named_in[place];
    named.begin = static_cast<std::uint32_t>(program_->namings.size());
    for (std::uint32_t i = 0; i < tree.formals.size(); ++i)
      program_->namings.push_back({std::string(tree.formals[i].name), i});
    first_local_ = program_->namings.size();
    if (!condition(tree, production.condition)) return false;
    const bool answer = tree.predecessor == "?E" && tree.purpose == Purpose::derivation;
    const std::size_t locals = lowering_.locals();
    if (!successor(tree.successor, answer, tree.after, production.successor)) return false;
    lowering_.forget_locals(locals);
    named.end = static_cast<std::uint32_t>(program_->namings.size());
    if (tree.weight.given() && !value(tree.weight, production.weight)) return false;
    production.by_chance = has_random(tree.before) || has_random(tree.condition) || has_random(tree.weight);
    const std::uint32_t neighbours = production.left.size() + production.right.size();
    const std::uint32_t code =
        cost_of(program_->code, production.condition.code) + cost_of(program_->code, production.weight.code);
    production.cost = 1 + code / 32 + neighbours / 8;
    program_->longest_successor = std::max(program_->longest_successor, production.successor.words);
    return true;
  }

  // Compiles a condition with the block before it; a block without a condition always matches.
  bool condition(const ProductionTree& tree, Value& condition) {
    if (tree.before.empty()) return value_if_given(tree.condition, condition);
    lowering_.begin_code();
    const std::uint32_t begin = lowering_.here();
    if (!assign(tree.before)) return false;
    condition.source = lowering_.number_register(1);
    if (tree.condition.given() && !take(lowering_.lower(tree.condition), condition.source)) return false;
    condition.code = {begin, lowering_.here()};
    condition.place = tree.condition.given() ? tree.condition.place : tree.place;
    condition.given = true;
    return true;
  }

  // Compiles the assignments of a block.
  bool assign(const std::vector<AssignmentTree>& block) {
    for (const AssignmentTree& assignment : block) {
      std::uint32_t source = 0;
      if (!take(lowering_.lower(assignment.expression), source)) return false;
      lowering_.assign(assignment.name, source);
      name_local(assignment.name, source);
    }
    return true;
  }

  // Compiles the left or right context of a production into a range of neighbours, whose parameters go to registers
  // from `to` on.
  bool context(const ProductionTree& tree, const std::vector<NeighbourTree>& wanted, Range& range, std::uint32_t& to) {
    std::vector<Neighbour>& neighbours = program_->neighbours;
    std::vector<std::uint32_t> open;
    range.begin = range.end = static_cast<std::uint32_t>(neighbours.size());
    if (tree.predecessor == "?E" && !wanted.empty())
      return fail(Reason::syntax, tree.place, message(messages::lsystem::query_with_context));
    for (const NeighbourTree& neighbour : wanted) {
      const std::uint32_t symbol = symbols_.find(neighbour.name, tree.system);
      if (symbols_.is_turtles(symbol) && !takes(symbol, neighbour.arity, neighbour.place)) return false;
      if (!symbols_.stands_for_itself(neighbour.name, symbol)) return read_as_one(neighbour.name, neighbour.place);
      if (symbol == push_symbol) open.push_back(range.end);
      if (symbol == pop_symbol) {
        neighbours[open.back()].closed = range.end;
        open.pop_back();
      } else if (symbol != push_symbol && program_->passed_over[symbol] != 0) {
        return fail(Reason::syntax, neighbour.place, message(messages::lsystem::context_ignored, neighbour.name));
      }
      neighbours.push_back({symbol, neighbour.arity, to, 0});
      to += neighbour.arity;
      ++range.end;
    }
    return true;
  }

  // Records a production's nearest neighbours, which are tested first, and whether more must be tested.
  void set_nearest(Production& production) const {
    const std::vector<Neighbour>& neighbours = program_->neighbours;
    const Range left = production.left, right = production.right;
    production.in_context = left.size() + right.size() > 0;
    production.looks_on = left.size() > 1 || right.size() > 1;
    const auto kind = [&](const Neighbour& wanted) {
      production.looks_on |= wanted.arity > 0;
      return header_of(wanted.symbol, wanted.arity, 0, program_->code.doubles);
    };
    if (left.size() > 0) production.nearest_left = kind(neighbours[left.end - 1]);
    if (right.size() > 0 && neighbours[right.begin].symbol != push_symbol)
      production.nearest_right = kind(neighbours[right.begin]);
  }

  // Whether productions may rewrite a symbol: brackets, % and some queries of the turtle they may not.
  bool may_rewrite(const ProductionTree& tree, std::uint32_t predecessor) {
    if (!symbols_.is_turtles(predecessor)) return true;
    const Action action = turtle_symbols[program_->meanings[predecessor]].action;
    const bool holds = action == Action::push || action == Action::pop || action == Action::cut;
    if (holds || (tree.predecessor[0] == '?' && tree.purpose != Purpose::derivation))
      return fail(Reason::syntax, tree.place, message(messages::lsystem::not_rewritable, tree.predecessor));
    return takes(predecessor, tree.arity, tree.place);
  }

  // Whether a turtle symbol can have a number of arguments.
  bool takes(std::uint32_t symbol, std::size_t count, const SourceLocation& place) {
    const TurtleSymbol& turtle = *program_->turtle(symbol);
    if (count <= turtle.max_arguments || passes_over(turtle.action)) return true;
    const MessageCode<3>& code =
        is_letter(turtle.symbol[0]) ? messages::lsystem::turtle_letter_arguments : messages::lsystem::turtle_arguments;
    return fail(Reason::syntax, place, message(code, program_->symbols[symbol], turtle.max_arguments, count));
  }

  // Records the register of a name that a block assigns, for traces; the last assignment counts.
  void name_local(std::string_view name, std::uint32_t source) {
    std::vector<Naming>& all = program_->namings;
    const auto found = std::find_if(all.begin() + static_cast<std::ptrdiff_t>(first_local_), all.end(),
                                    [&](const Naming& naming) { return naming.name == name; });
    if (found == all.end())
      all.push_back({std::string(name), source});
    else
      found->source = source;
  }

  // Whether the turtle ignores arguments behind the first: cpfg's lines may have further ones behind the length.
  bool passes_over(Action action) const {
    return grammar_.notation == Notation::cpfg && (action == Action::line || action == Action::move ||
                                                   action == Action::line_apart || action == Action::move_apart);
  }

  // Compiles an expression.
  bool value(const Expression& expression, Value& value) {
    lowering_.begin_code();
    const std::uint32_t begin = lowering_.here();
    if (!take(lowering_.lower(expression), value.source)) return false;
    value.code = {begin, lowering_.here()};
    value.place = expression.place;
    value.given = true;
    return true;
  }

  // Compiles a successor into a template: words to copy, and the code and patches that fill in its parameters.
  bool successor(const std::vector<ModuleTree>& modules, bool answer, const std::vector<AssignmentTree>& block,
                 Template& result) {
    Program& program = *program_;
    lowering_.begin_code();
    first_ = result.first = static_cast<std::uint32_t>(program.words.size());
    result.code.begin = lowering_.here();
    result.patches.begin = static_cast<std::uint32_t>(program.patches.size());
    result.births.begin = static_cast<std::uint32_t>(program.births.size());
    result.active.begin = static_cast<std::uint32_t>(program.active.size());
    if (!assign(block)) return false;
    for (const ModuleTree& tree : modules)
      if (!module(tree, answer)) return false;
    for (const ModuleTree& tree : modules) ordinals_[symbols_.find(tree.name, tree.system)] = 0;
    result.modules = static_cast<std::uint32_t>(modules.size());
    result.words = static_cast<std::uint32_t>(program.words.size()) - first_;
    result.code.end = lowering_.here();
    result.patches.end = static_cast<std::uint32_t>(program.patches.size());
    result.births.end = static_cast<std::uint32_t>(program.births.size());
    result.active.end = static_cast<std::uint32_t>(program.active.size());
    result.cost = (cost_of(program.code, result.code) + result.words) / 32;
    return true;
  }

  // Compiles a module of a successor or axiom: its words, and code for parameters that are computed. `answer`: whether
  // it answers a query of the turtle, where only modules that can be drawn are allowed.
  bool module(const ModuleTree& tree, bool answer) {
    Program& program = *program_;
    const std::uint32_t symbol = symbols_.find(tree.name, tree.system);
    const std::size_t count = tree.arguments.size();
    if (symbols_.is_turtles(symbol) && !takes(symbol, count, tree.place)) return false;
    program.locates |= program.is_turtle_query(symbol);
    program.has_queries |= symbol == query_symbol;
    if (answer && !drawable(tree, symbol)) return false;
    if (!symbols_.stands_for_itself(tree.name, symbol)) return read_as_one(tree.name, tree.place);

    const std::size_t at = program.words.size();
    const bool active = symbol == cut_symbol || symbols_.is_derived(symbol, count);
    const bool lineage = program.lineages && symbols_.remembers(symbol);
    const bool doubles = program.code.doubles;
    const std::size_t single_words = 1 + count + (lineage ? lineage_words : 0);
    const std::size_t words = single_words + (doubles ? 2 * count : 0);
    program.words.push_back(
        header_of(symbol, static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(words), doubles));
    std::vector<double> known;
    for (const Expression& argument : tree.arguments) {
      const std::size_t precise = at + single_words + 2 * known.size() - first_;
      if (!parameter(argument, symbol, static_cast<std::uint32_t>(precise), known.emplace_back())) return false;
    }
    if (lineage) {
      const std::uint32_t ordinal = ordinals_[symbol]++;
      program.births.push_back(
          {static_cast<std::uint32_t>(program.words.size()) - first_, hash_combine(hash_text(tree.name), ordinal)});
      program.words.resize(program.words.size() + lineage_words);
    }
    if (doubles) {
      program.words.resize(at + words);
      if (count > 0) std::memcpy(program.words.data() + at + single_words, known.data(), count * sizeof(double));
    }
    if (active) program.active.push_back(static_cast<std::uint32_t>(at) - first_);
    return true;
  }

  // Whether a module of a response is allowed: it must be drawable in place, or rewritten in a later step.
  bool drawable(const ModuleTree& tree, std::uint32_t symbol) {
    if (symbols_.is_turtles(symbol) && symbol != query_symbol) return true;
    Diagnostic& error = program_->not_drawable;
    if (error.reason == Reason::none)
      error = error_at(Reason::syntax, tree.place, message(messages::lsystem::response_not_drawable, tree.name));
    // In cpfg's notation responses always come between steps.
    const bool between = grammar_.steps.given() || grammar_.notation == Notation::cpfg;
    if (!between) error_ = error;
    return between;
  }

  // Fails since a name was probably meant as several symbols.
  bool read_as_one(std::string_view name, const SourceLocation& place) {
    return fail(Reason::syntax, place, message(messages::lsystem::read_as_one, name));
  }

  // Compiles a parameter of a module of `symbol`: a constant, or a patch that fills it in. `precise` is the offset of
  // its double in the template; `known` becomes its value if that depends on the text alone.
  bool parameter(const Expression& expression, std::uint32_t symbol, std::uint32_t precise, double& known) {
    Program& program = *program_;
    std::uint32_t source = 0;
    if (!take(lowering_.lower(expression), source)) return false;
    Demand demand = Demand::none;
    if (symbols_.is_turtles(symbol))
      demand = program.turtle(symbol)->non_negative ? Demand::not_negative : Demand::finite;
    Patch patch{
        static_cast<std::uint32_t>(program.words.size()) - first_, precise, source, demand, symbol, expression.place};
    std::uint32_t word = 0;
    switch (lowering_.known(source)) {
      case Lowering::Known::now: {
        const float value = program.code.registers[source];
        if (!Machine::meets(demand, value)) {
          error_ = Machine::refusal(program, patch, value);
          return false;
        }
        std::memcpy(&word, &value, sizeof word);
        known = program.code.doubles ? program.code.precise[source] : value;
        break;
      }
      case Lowering::Known::once_bound:
        patch.offset += first_;
        patch.precise += first_;
        program.bound_patches.push_back(patch);
        break;
      case Lowering::Known::on_the_run:
        program.patches.push_back(patch);
        break;
    }
    program.words.push_back(word);
    return true;
  }

  const Grammar& grammar_;
  std::shared_ptr<Program> program_;
  Lowering lowering_;
  SymbolTable symbols_;
  std::vector<std::uint32_t> ordinals_;  // by symbol: how many stand before in the successor
  std::uint32_t first_ = 0;              // word of the template
  std::size_t first_local_ = 0;          // naming of the production
  Diagnostic error_;
};

}  // namespace

Result<std::shared_ptr<const Program>> compile(std::string_view text, const Limits& limits, Lineages lineages,
                                               Notation notation) {
  if (text.size() > limits.text_bytes)
    return error_at(Reason::limit, {}, message(messages::lsystem::text_too_long, text.size(), limits.text_bytes));
  const Result<Grammar> grammar = parse(text, notation);
  if (!grammar) return grammar.error();
  return Compiler(grammar.value(), lineages).run();
}

// Properties of a compiled program: roles of symbols, whether it queries the environment, and its symbols by number.
const Roles& roles(const Program& program) { return program.roles; }

bool has_queries(const Program& program) { return program.has_queries; }

std::span<const std::string> symbols(const Program& program) { return program.symbols; }

// The symbols that productions rewrite, in the order of the text.
std::vector<std::string_view> predecessors(const Program& program) {
  std::vector<std::string_view> names;
  for (const std::uint32_t symbol : program.predecessors) names.push_back(program.symbols[symbol]);
  return names;
}

}  // namespace panicle::lsystem
