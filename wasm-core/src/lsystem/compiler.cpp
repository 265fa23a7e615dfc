#include <algorithm>
#include <utility>

#include "foundation/random.hpp"
#include "lsystem/lowering.hpp"
#include "lsystem/machine.hpp"
#include "lsystem/names.hpp"
#include "lsystem/number_text.hpp"
#include "lsystem/parser.hpp"
#include "lsystem/program.hpp"
#include "lsystem/remarks.hpp"

namespace panicle::lsystem {
namespace {

constexpr std::size_t most_symbols = 0xfff0;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool draws(const Expression& expression) {
  return std::any_of(expression.nodes.begin(), expression.nodes.end(),
                     [](const Node& node) { return is_random(node.op); });
}

bool draws(const std::vector<ModuleTree>& modules) {
  for (const ModuleTree& module : modules)
    for (const Expression& argument : module.arguments)
      if (draws(argument)) return true;
  return false;
}

bool asks(const std::vector<ModuleTree>& modules) {
  return std::any_of(modules.begin(), modules.end(), [](const ModuleTree& module) { return module.name == "?E"; });
}

// Whether a program cannot do without lineages.
bool needs_lineages(const Grammar& grammar) {
  if (draws(grammar.axiom) || asks(grammar.axiom)) return true;
  for (const ProductionTree& production : grammar.productions) {
    if (production.weight.given() || asks(production.successor) || draws(production.successor)) return true;
    if (draws(production.condition)) return true;
  }
  return false;
}

class Compiler {
 public:
  Compiler(const Grammar& grammar, Lineages lineages)
      : grammar_(grammar), program_(std::make_shared<Program>()), lowering_(program_->code) {
    program_->lineages = lineages == Lineages::always || needs_lineages(grammar);
  }

  Result<std::shared_ptr<const Program>> run() {
    const bool fine = declarations() && symbols() && roles() && sight() && axiom() && productions();
    if (!fine) return trouble_;
    program_->once_bound = lowering_.finish();
    program_->remarks = remarks_on(grammar_);
    program_->words.resize(program_->words.size() + block);  // room for copies in whole blocks
    return std::shared_ptr<const Program>(std::move(program_));
  }

 private:
  bool fail(Reason reason, const Place& place, const char* pattern, Pieces pieces = {}) {
    trouble_ = error_at(reason, place, pattern, pieces);
    return false;
  }

  template <class Value>
  bool take(const Result<Value>& result, Value& value) {
    if (result) return value = result.value(), true;
    trouble_ = result.error();
    return false;
  }

  // Reading of a #define that is given with the request goes wrong all the same where it uses what is not there.
  bool declarations() {
    for (const DefinitionTree& definition : grammar_.definitions) {
      Declaration declaration{std::string(definition.name), definition.kind, definition.place, {}, 0};
      const bool array = definition.kind == Definition::Kind::array;
      if (definition.kind == Definition::Kind::define && !value(definition.expression, declaration.value)) return false;
      declaration.to = array ? lowering_.define_array(definition.name) : lowering_.define(definition.name);
      program_->declarations.push_back(std::move(declaration));
    }
    return !grammar_.steps.given() || value(grammar_.steps, program_->steps);
  }

  bool symbols() {
    for (const TurtleSymbol& turtle : turtle_symbols) add_symbol(turtle.symbol);
    for (const ModuleTree& module : grammar_.axiom) add_symbol(module.name);
    for (const ProductionTree& production : grammar_.productions) {
      const std::uint32_t predecessor = add_symbol(production.predecessor);
      if (!is_rewritten(predecessor)) program_->predecessors.push_back(predecessor);
      rewritten_[predecessor] |= std::uint64_t{1} << production.arity;
      for (const NeighbourTree& neighbour : production.left) add_symbol(neighbour.name);
      for (const NeighbourTree& neighbour : production.right) add_symbol(neighbour.name);
      for (const ModuleTree& module : production.successor) add_symbol(module.name);
    }
    if (program_->symbols.size() > most_symbols)
      return fail(Reason::limit, grammar_.axiom.front().place, "The grammar has more than 65,520 symbols; use fewer.");
    return true;
  }

  std::uint32_t add_symbol(std::string_view name) {
    const std::uint32_t number = numbers_.add(name);
    if (number == program_->symbols.size()) {
      program_->symbols.emplace_back(name);
      rewritten_.push_back(0);
      ordinals_.push_back(0);
    }
    return number;
  }

  bool is_rewritten(std::uint32_t symbol) const { return rewritten_[symbol] != 0; }

  bool roles() {
    Roles& roles = program_->roles;
    roles.of_symbol.assign(program_->symbols.size(), Roles::none);
    for (const RoleTree& tree : grammar_.roles) {
      const auto found = std::find(roles.names.begin(), roles.names.end(), tree.name);
      const auto role = static_cast<std::uint32_t>(found - roles.names.begin());
      if (found == roles.names.end()) roles.names.emplace_back(tree.name);
      for (const Named& symbol : tree.symbols)
        if (!give_role(role, symbol)) return false;
    }
    return true;
  }

  bool give_role(std::uint32_t role, const Named& symbol) {
    Roles& roles = program_->roles;
    const std::uint32_t number = numbers_.find(symbol.name);
    if (number == Names::none)
      return fail(Reason::undefined, symbol.place,
                  "Neither the axiom nor a production has the symbol '%'; take it out of the role.", {symbol.name});
    if (is_turtle_symbol(number))
      return fail(Reason::syntax, symbol.place,
                  "'%' is the turtle's and has no role; give one to the symbol that writes it.", {symbol.name});
    std::uint32_t& given = roles.of_symbol[number];
    if (given != Roles::none && given != role)
      return fail(Reason::syntax, symbol.place, "'%' has the role '%' already; a symbol has one.",
                  {symbol.name, roles.names[given]});
    given = role;
    return true;
  }

  // What contexts do not see.
  bool sight() {
    const SightTree& sight = grammar_.sight;
    const bool consider = sight.kind == SightTree::Kind::consider;
    program_->passed_over.assign(program_->symbols.size(), consider);
    for (const Named& symbol : sight.symbols) {
      const std::uint32_t number = numbers_.find(symbol.name);
      if (number == Names::none)
        return fail(Reason::undefined, symbol.place,
                    "Nothing in this text has the symbol '%'; take it out of the list, or put spaces between several.",
                    {symbol.name});
      program_->passed_over[number] = !consider;
    }
    return true;
  }

  bool axiom() {
    lowering_.begin_production({}, hash_text("axiom"));
    return successor(grammar_.axiom, false, program_->axiom);
  }

  // Productions stand by predecessor, each symbol's in the order of the text.
  bool productions() {
    make_places();
    for (const ProductionTree& tree : grammar_.productions) {
      const std::uint32_t predecessor = numbers_.find(tree.predecessor);
      if (!may_rewrite(tree, predecessor)) return false;
      Rules& rules = program_->rules[predecessor];
      lowering_.begin_production(tree.formals, rules.productions.size());
      if (!production(tree, program_->productions[rules.productions.end])) return false;
      ++rules.productions.end;
      rules.weighted |= tree.weight.given();
      const Production& added = program_->productions[rules.productions.end - 1];
      rules.by_chance |= rules.weighted || added.by_chance;
      rules.in_context |= added.in_context;
      program_->in_context |= added.in_context;
    }
    return true;
  }

  void make_places() {
    std::vector<std::uint32_t> counts(program_->symbols.size(), 0);
    for (const ProductionTree& tree : grammar_.productions) ++counts[numbers_.find(tree.predecessor)];
    std::uint32_t first = 0;
    for (const std::uint32_t count : counts) {
      program_->rules.push_back({{first, first}, false, false, false});
      first += count;
    }
    program_->productions.resize(first);
  }

  bool production(const ProductionTree& tree, Production& production) {
    production.predecessor = numbers_.find(tree.predecessor);
    production.place = tree.place;
    production.arity = tree.arity;
    std::uint32_t to = tree.arity;
    if (!context(tree, tree.left, production.left, to) || !context(tree, tree.right, production.right, to))
      return false;
    production.in_context = production.left.size() + production.right.size() > 0;
    if (tree.condition.given() && !value(tree.condition, production.condition)) return false;
    if (!successor(tree.successor, tree.predecessor == "?E", production.successor)) return false;
    if (tree.weight.given() && !value(tree.weight, production.weight)) return false;
    production.by_chance = draws(tree.condition) || draws(tree.weight);
    const std::uint32_t neighbours = production.left.size() + production.right.size();
    production.cost = 1 + (production.condition.code.size() + production.weight.code.size()) / 32 + neighbours / 8;
    program_->longest_successor = std::max(program_->longest_successor, production.successor.words);
    return true;
  }

  // Its parameters go to registers from `to` on.
  bool context(const ProductionTree& tree, const std::vector<NeighbourTree>& wanted, Range& range, std::uint32_t& to) {
    std::vector<Neighbour>& neighbours = program_->neighbours;
    std::vector<std::uint32_t> open;
    range.begin = range.end = static_cast<std::uint32_t>(neighbours.size());
    if (tree.predecessor == "?E" && !wanted.empty())
      return fail(Reason::syntax, tree.place,
                  "?E is answered by the environment and has no context; let its neighbour look at it, A > ?E(x).");
    for (const NeighbourTree& neighbour : wanted) {
      const std::uint32_t symbol = numbers_.find(neighbour.name);
      if (is_turtle_symbol(symbol) && !takes(symbol, neighbour.arity, neighbour.place)) return false;
      if (!stands_for_itself(neighbour.name, symbol)) return read_as_one(neighbour.name, neighbour.place);
      if (symbol == push_symbol) open.push_back(range.end);
      if (symbol == pop_symbol) {
        neighbours[open.back()].closed = range.end;
        open.pop_back();
      } else if (symbol != push_symbol && program_->passed_over[symbol] != 0) {
        return fail(Reason::syntax, neighbour.place,
                    "Contexts do not see '%'; take it out of ignore:, or put it into consider:.", {neighbour.name});
      }
      neighbours.push_back({symbol, neighbour.arity, to, 0});
      to += neighbour.arity;
      ++range.end;
    }
    return true;
  }

  bool may_rewrite(const ProductionTree& tree, std::uint32_t predecessor) {
    if (!is_turtle_symbol(predecessor)) return true;
    const Action action = turtle_symbols[predecessor].action;
    if (action == Action::push || action == Action::pop || action == Action::cut)
      return fail(Reason::syntax, tree.place, "'%' cannot be rewritten; use a symbol of your own.", {tree.predecessor});
    return takes(predecessor, tree.arity, tree.place);
  }

  bool takes(std::uint32_t symbol, std::size_t count, const Place& place) {
    const TurtleSymbol& turtle = turtle_symbols[symbol];
    if (count <= turtle.most_arguments) return true;
    const char* most = turtle.most_arguments == 0 ? " takes no argument" : " takes at most one argument";
    const char* otherwise = is_letter(turtle.symbol[0]) ? ", or name a symbol of your own otherwise." : ".";
    return fail(Reason::syntax, place, "'%' (%)%, but here it has %; leave out the rest%",
                {turtle.symbol, turtle.name, most, std::to_string(count), otherwise});
  }

  bool value(const Expression& expression, Value& value) {
    lowering_.begin_code();
    const std::uint32_t begin = lowering_.here();
    if (!take(lowering_.lower(expression), value.source)) return false;
    value.code = {begin, lowering_.here()};
    value.place = expression.place;
    value.given = true;
    return true;
  }

  bool successor(const std::vector<ModuleTree>& modules, bool answer, Template& result) {
    Program& program = *program_;
    lowering_.begin_code();
    first_ = result.first = static_cast<std::uint32_t>(program.words.size());
    result.code.begin = lowering_.here();
    result.patches.begin = static_cast<std::uint32_t>(program.patches.size());
    result.births.begin = static_cast<std::uint32_t>(program.births.size());
    result.active.begin = static_cast<std::uint32_t>(program.active.size());
    for (const ModuleTree& tree : modules)
      if (!module(tree, answer)) return false;
    for (const ModuleTree& tree : modules) ordinals_[numbers_.find(tree.name)] = 0;
    result.modules = static_cast<std::uint32_t>(modules.size());
    result.words = static_cast<std::uint32_t>(program.words.size()) - first_;
    result.code.end = lowering_.here();
    result.patches.end = static_cast<std::uint32_t>(program.patches.size());
    result.births.end = static_cast<std::uint32_t>(program.births.size());
    result.active.end = static_cast<std::uint32_t>(program.active.size());
    result.cost = (result.code.size() + result.words) / 32;
    return true;
  }

  bool module(const ModuleTree& tree, bool answer) {
    Program& program = *program_;
    const std::uint32_t symbol = numbers_.find(tree.name);
    const std::size_t count = tree.arguments.size();
    if (is_turtle_symbol(symbol) && !takes(symbol, count, tree.place)) return false;
    if (answer && !drawable(tree, symbol)) return false;
    if (!stands_for_itself(tree.name, symbol)) return read_as_one(tree.name, tree.place);

    const std::size_t at = program.words.size();
    const bool active = symbol == cut_symbol || (rewritten_[symbol] >> count & 1) != 0;
    const bool lineage = program.lineages && remembers(symbol);
    const std::size_t words = 1 + count + (lineage ? lineage_words : 0);
    program.words.push_back(header_of(symbol, static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(words)));
    for (const Expression& argument : tree.arguments)
      if (!parameter(argument, symbol)) return false;
    if (lineage) {
      const std::uint32_t ordinal = ordinals_[symbol]++;
      program.births.push_back(
          {static_cast<std::uint32_t>(program.words.size()) - first_, hash_combine(hash_text(tree.name), ordinal)});
      program.words.resize(program.words.size() + lineage_words);
    }
    if (active) program.active.push_back(static_cast<std::uint32_t>(at) - first_);
    return true;
  }

  // An answer is drawn in place unless it is rewritten in the next of a given number of steps.
  bool drawable(const ModuleTree& tree, std::uint32_t symbol) {
    if (is_turtle_symbol(symbol) && symbol != ask_symbol) return true;
    Diagnostic& trouble = program_->not_drawable;
    if (trouble.reason == Reason::none)
      trouble = error_at(Reason::syntax, tree.place,
                         "What answers ?E is drawn at once, so only the turtle's symbols can stand here, not '%'; with "
                         "a derivation length answers can be rewritten in the next step instead.",
                         {tree.name});
    if (!grammar_.steps.given()) trouble_ = trouble;
    return grammar_.steps.given();
  }

  // Modules whose lineage someone may ask for: those that write others, and those that listeners hear of.
  bool remembers(std::uint32_t symbol) const {
    if (is_rewritten(symbol)) return true;
    if (!is_turtle_symbol(symbol)) return false;
    const Action action = turtle_symbols[symbol].action;
    return action == Action::line || action == Action::sphere || action == Action::ask;
  }

  // `FF` or `AB` where F, A and B mean something and the whole does not: in cpfg two modules, here one that does
  // nothing.
  bool stands_for_itself(std::string_view name, std::uint32_t symbol) const {
    if (is_turtle_symbol(symbol) || is_rewritten(symbol)) return true;
    for (std::size_t i = 0; i < name.size(); ++i) {
      const std::uint32_t letter = numbers_.find(name.substr(i, 1));
      if (letter == Names::none || !(is_turtle_symbol(letter) || is_rewritten(letter))) return true;
    }
    return false;
  }

  bool read_as_one(std::string_view name, const Place& place) {
    return fail(Reason::syntax, place, "'%' is read as one symbol, which nothing defines; put spaces between several.",
                {name});
  }

  bool parameter(const Expression& expression, std::uint32_t symbol) {
    Program& program = *program_;
    std::uint32_t source = 0;
    if (!take(lowering_.lower(expression), source)) return false;
    Demand demand = Demand::none;
    if (is_turtle_symbol(symbol)) demand = turtle_symbols[symbol].non_negative ? Demand::not_negative : Demand::finite;
    Patch patch{static_cast<std::uint32_t>(program.words.size()) - first_, source, demand, symbol, expression.place};
    std::uint32_t word = 0;
    switch (lowering_.known(source)) {
      case Lowering::Known::now: {
        const float value = program.code.registers[source];
        if (!Machine::meets(demand, value)) {
          trouble_ = Machine::refusal(program, patch, value);
          return false;
        }
        std::memcpy(&word, &value, sizeof word);
        break;
      }
      case Lowering::Known::once_bound:
        patch.offset += first_;
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
  Names numbers_;                         // of symbols
  std::vector<std::uint64_t> rewritten_;  // by symbol: a bit for each arity (at most 32) of its productions
  std::vector<std::uint32_t> ordinals_;   // by symbol: how many stand before in the successor
  std::uint32_t first_ = 0;               // word of the template
  Diagnostic trouble_;
};

}  // namespace

Result<std::shared_ptr<const Program>> compile(std::string_view text, const Limits& limits, Lineages lineages) {
  if (text.size() > limits.text_bytes)
    return error_at(Reason::limit, {}, "The grammar is % bytes long; the limit is %.",
                    {std::to_string(text.size()), std::to_string(limits.text_bytes)});
  const Result<Grammar> grammar = parse(text);
  if (!grammar) return grammar.error();
  return Compiler(grammar.value(), lineages).run();
}

const Roles& roles(const Program& program) { return program.roles; }

std::span<const std::string> symbols(const Program& program) { return program.symbols; }

std::vector<std::string_view> predecessors(const Program& program) {
  std::vector<std::string_view> names;
  for (const std::uint32_t symbol : program.predecessors) names.push_back(program.symbols[symbol]);
  return names;
}

}  // namespace panicle::lsystem
