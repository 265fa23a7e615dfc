#include "lsystem/syntax/production_remarks.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "expression/messages.generated.hpp"
#include "expression/names.hpp"
#include "expression/number_text.hpp"
#include "lsystem/messages.generated.hpp"
#include "lsystem/turtle/turtle_symbols.generated.hpp"

namespace panicle::lsystem {

// The turtle is the moving pen that draws a string.

namespace {

constexpr std::uint32_t none = Names::none;

// The line of a place, as text.
std::string line_of(const SourceLocation& place) { return std::to_string(place.line); }

// Numbers symbols. Each L-system of the text has its own symbols: the same name in another one has another number.
class SymbolNumbers {
 public:
  // The number of a symbol of an L-system.
  std::uint32_t number(std::string_view name, std::uint32_t system) {
    key_.assign(name);
    if (system != 0 && name[0] != '?') key_.append("\x1f").append(std::to_string(system));
    return names_.add(key_);
  }

 private:
  Names names_;
  std::string key_;
};

// A value for each symbol, default-constructed when it is first used.
template <class Value>
class BySymbol {
 public:
  Value& operator[](std::uint32_t symbol) {
    if (symbol >= values_.size()) values_.resize(symbol + 1);
    return values_[symbol];
  }

 private:
  std::vector<Value> values_;
};

// Finder of productions that can never apply, for remarks (notes on a text that is valid but probably not meant).
class ProductionChecker {
 public:
  explicit ProductionChecker(const Grammar& grammar) : grammar_(grammar) {}

  // Runs all checks; returns the remarks.
  std::vector<Remark> run() {
    check_arities();
    check_order();
    check_contexts();
    return std::move(remarks_);
  }

 private:
  // Adds a remark.
  void add(const SourceLocation& place, const Message& problem) {
    remarks_.push_back({problem, place.line, place.column});
  }

  // Whether the turtle draws a module of this name that no production rewrites.
  bool is_turtle_symbol(std::string_view name) const {
    return std::any_of(turtle_symbols.begin(), turtle_symbols.end(), [&](const TurtleSymbol& turtle) {
      return turtle.symbol == name && (!turtle.cpfg_only || grammar_.notation == Notation::cpfg);
    });
  }

  // The numbers of parameters of one symbol, as bit sets.
  struct Arities {
    std::uint64_t written = 0;              // of its modules in axiom and successors
    std::uint64_t rewritten = 0;            // of the predecessors of its productions
    std::uint64_t remarked = 0;             // that have a remark already
    const ProductionTree* first = nullptr;  // production
  };

  // Calls `each` for every module of axiom and successors.
  template <class Each>
  void each_module(const Each& each) const {
    for (const ModuleTree& module : grammar_.axiom) each(module);
    for (const ProductionTree& production : grammar_.productions)
      for (const ModuleTree& module : production.successor) each(module);
  }

  // Remarks on modules with a number of parameters that no production has, and on productions that no module suits.
  void check_arities() {
    BySymbol<Arities> by_symbol;
    for (const ProductionTree& production : grammar_.productions) {
      Arities& arities = by_symbol[symbols_.number(production.predecessor, production.system)];
      arities.rewritten |= std::uint64_t{1} << production.arity;
      if (arities.first == nullptr) arities.first = &production;
    }
    each_module([&](const ModuleTree& module) {
      Arities& arities = by_symbol[symbols_.number(module.name, module.system)];
      const std::uint64_t bit = std::uint64_t{1} << module.arguments.size();
      arities.written |= bit;
      if (is_turtle_symbol(module.name)) return;
      if (arities.rewritten == 0 || ((arities.rewritten | arities.remarked) & bit) != 0) return;
      arities.remarked |= bit;
      const std::string line = line_of(arities.first->place);
      add(module.place, message(messages::lsystem::remark_parameter_count, module.name,
                                message(messages::expression::term_parameters, module.arguments.size()), line,
                                message(messages::expression::term_parameters, arities.first->arity)));
    });
    for (const ProductionTree& production : grammar_.productions) {
      const Arities& arities = by_symbol[symbols_.number(production.predecessor, production.system)];
      const std::uint64_t bit = std::uint64_t{1} << production.arity;
      if (arities.written == 0 || arities.remarked != 0 || (arities.written & bit) != 0 ||
          production.predecessor[0] == '?')
        continue;
      add(production.place, message(messages::lsystem::remark_no_module, production.predecessor,
                                    message(messages::expression::term_parameters, production.arity)));
    }
  }

  // The contexts of a production as a key: equal where two productions require the same neighbours, empty without
  // contexts.
  static std::string context_key(const ProductionTree& production) {
    std::string bytes;
    for (const auto* side : {&production.left, &production.right}) {
      for (const NeighbourTree& neighbour : *side)
        bytes.append(neighbour.name).append("\x1f").append(std::to_string(neighbour.arity)).append("\x1e");
      if (!production.left.empty() || !production.right.empty()) bytes += '\x1d';
    }
    return bytes;
  }

  // The condition of a production as a key, equal where two conditions are the same. Empty without a condition, and
  // where it has a random draw or a query or follows a block: then no two are known to be the same.
  std::string condition_key(const ProductionTree& production) const {
    std::string bytes;
    for (const Node& node : production.condition.nodes) {
      if (node.kind == Node::Kind::operation && (is_random(node.op) || is_space_query(node.op))) return {};
      // Two numbers are the same if they are so in the precision of the text.
      const double value = grammar_.doubles ? node.precise : node.number;
      char number[sizeof value];
      std::memcpy(number, &value, sizeof number);
      bytes += static_cast<char>('A' + static_cast<int>(node.kind));
      bytes.append(std::to_string(static_cast<int>(node.op))).append(number, sizeof number);
      bytes.append(std::to_string(node.curve)).append(name_key(production, node.name)).append("\x1e");
    }
    return production.before.empty() ? bytes : std::string();
  }

  // A formal parameter is written as its position, since it may have another name in another production.
  static std::string name_key(const ProductionTree& production, std::string_view name) {
    for (std::size_t i = 0; i < production.formals.size(); ++i)
      if (production.formals[i].name == name) return "\x1f" + std::to_string(i);
    return std::string(name);
  }

  // Whether a production has a weight.
  static bool has_weight(const ProductionTree& production) { return production.weight.given(); }
  // Whether the weight is a positive constant, so that the production is drawn sooner or later.
  static bool has_positive_weight(const ProductionTree& production) {
    const std::vector<Node>& nodes = production.weight.nodes;
    return nodes.size() == 1 && nodes[0].kind == Node::Kind::number && nodes[0].number > 0;
  }

  // Finds productions that an earlier one always precedes. Of the productions that match a module the first is applied;
  // if it has a weight, one is drawn from it and the later ones with a weight (Machine::draw_production).
  void check_order() {
    Names keys;
    struct Earlier {
      std::uint32_t plain = none, weighted = none;  // lines of the first production without and with a weight
      bool alone = false;                           // whether no production with a weight precedes the plain one
    };
    std::vector<Earlier> earlier;
    Names groups;
    std::vector<std::uint8_t> has_weighted;
    const auto find = [&](const std::string& key) {
      const std::uint32_t number = keys.find(key);
      return number == none ? Earlier{} : earlier[number];
    };
    for (const ProductionTree& production : grammar_.productions) {
      const std::string group = std::to_string(static_cast<int>(production.purpose)) + "," +
                                std::to_string(symbols_.number(production.predecessor, production.system)) + "," +
                                std::to_string(production.arity);
      const std::uint32_t group_number = groups.add(group);
      has_weighted.resize(groups.size());
      const std::string context = context_key(production), condition = condition_key(production);
      const bool conditional = production.condition.given();
      const auto key = [&](const std::string& neighbours, const std::string& test) {
        return group + "\x1c" + neighbours + "\x1c" + test;
      };
      std::uint32_t line = none;
      const auto compare = [&](const Earlier& of) {
        if (of.plain != none && (!has_weight(production) || of.alone)) line = of.plain;
        if (of.weighted != none && !has_weight(production)) line = of.weighted;
      };
      compare(find(key({}, {})));
      if (!context.empty()) compare(find(key(context, {})));
      if (!condition.empty()) compare(find(key({}, condition)));
      if (!condition.empty() && !context.empty()) compare(find(key(context, condition)));
      if (line != none) add(production.place, message(messages::lsystem::remark_never_first, line));
      if (has_weight(production)) has_weighted[group_number] = 1;
      if (conditional && (condition.empty() || is_number(production.condition))) continue;
      const std::uint32_t number = keys.add(key(context, condition));
      if (number == earlier.size()) earlier.emplace_back();
      Earlier& of = earlier[number];
      if (has_weight(production)) {
        if (of.weighted == none && has_positive_weight(production)) of.weighted = production.place.line;
      } else if (of.plain == none) {
        of.plain = production.place.line;
        of.alone = has_weighted[group_number] == 0;
      }
    }
  }

  // Whether an expression is a single number.
  static bool is_number(const Expression& expression) {
    return expression.nodes.size() == 1 && expression.nodes[0].kind == Node::Kind::number;
  }

  // Two symbols in the order of a string, and a place in the text.
  struct Pair {
    std::uint32_t before, after;
    SourceLocation place;
  };

  // The pairs of neighbours for left contexts, which follow the path to the root, or for right contexts, which follow
  // the axis of the module.
  struct Side {
    std::vector<Pair> beside;  // pairs that contexts match
    std::vector<Pair> first;   // of each production: its symbol, and a symbol that its successor begins with
    // Pairs with a bracket between them that contexts do not pass, each once, and the place of the first.
    Names bracketed;
    std::vector<SourceLocation> places;

    // Stores a place where a branch follows a symbol, the first one of each pair.
    void add_bracketed(std::uint32_t before, std::uint32_t after, const SourceLocation& place) {
      if (bracketed.add(key(before, after)) == places.size()) places.push_back(place);
    }
    static std::string key(std::uint32_t before, std::uint32_t after) {
      return std::to_string(before) + ',' + std::to_string(after);
    }
  };

  // Finds contexts whose nearest neighbour is only ever behind a bracket. In `[A] B` A ends a branch before B; in `A
  // [B]` B begins a branch behind A.
  void check_contexts() {
    const bool any = std::any_of(grammar_.productions.begin(), grammar_.productions.end(), [](const auto& production) {
      return !production.left.empty() || !production.right.empty();
    });
    if (!any) return;
    for (const Named& symbol : grammar_.sight.symbols) listed_.add(symbol.name);
    collect_pairs(grammar_.axiom, nullptr);
    for (const ProductionTree& production : grammar_.productions) collect_pairs(production.successor, &production);
    if (may_vanish_) return;  // modules between two others may be removed, with their brackets
    std::size_t searches = 0;
    for (const ProductionTree& production : grammar_.productions) {
      const std::uint32_t symbol = symbols_.number(production.predecessor, production.system);
      if (!production.left.empty()) {
        const NeighbourTree& nearest = production.left.back();
        const std::uint32_t wanted = symbols_.number(nearest.name, production.system);
        if (const SourceLocation* const place = only_bracketed(left_, wanted, symbol, searches))
          add(nearest.place,
              message(messages::lsystem::remark_left_branch, nearest.name, production.predecessor, line_of(*place)));
      }
      if (!production.right.empty() && production.right[0].name != "[") {
        const NeighbourTree& nearest = production.right[0];
        const std::uint32_t wanted = symbols_.number(nearest.name, production.system);
        if (const SourceLocation* const place = only_bracketed(right_, symbol, wanted, searches))
          add(nearest.place,
              message(messages::lsystem::remark_right_branch, nearest.name, production.predecessor, line_of(*place)));
      }
    }
  }

  // The place where two symbols have a bracket between them, if no rewriting can make them neighbours without one; null
  // otherwise, and after `max_searches`.
  const SourceLocation* only_bracketed(const Side& side, std::uint32_t before, std::uint32_t after,
                                       std::size_t& searches) const {
    static constexpr std::size_t max_searches = 32;  // each visits all pairs
    const std::uint32_t found = side.bracketed.find(Side::key(before, after));
    if (found == none || ++searches > max_searches) return nullptr;
    const std::vector<bool> may_end = reaching(last_, before), may_begin = reaching(side.first, after);
    for (const Pair& pair : side.beside)
      if (may_end[pair.before] && may_begin[pair.after]) return nullptr;
    return &side.places[found];
  }

  // By symbol: whether it is `symbol` or is rewritten to it at that end in any number of steps. True for all symbols
  // where that takes more than 32 rounds to find out.
  std::vector<bool> reaching(const std::vector<Pair>& becomes, std::uint32_t symbol) const {
    std::vector<bool> reaches(largest_symbol_ + 1);
    reaches[symbol] = true;
    std::uint32_t rounds = 0;
    for (bool more = true; more;) {
      more = false;
      if (++rounds > 32) return std::vector<bool>(reaches.size(), true);
      for (const Pair& pair : becomes) {
        if (reaches[pair.before] || !reaches[pair.after]) continue;
        reaches[pair.before] = more = true;
      }
    }
    return reaches;
  }

  // Whether contexts match the symbol: `ignore:` and `consider:` hide others.
  bool is_visible(std::string_view name) const {
    const bool listed = listed_.find(name) != none;
    return grammar_.sight.kind == ContextFilterTree::Kind::consider ? listed : !listed;
  }

  // One level of brackets.
  struct Level {
    std::uint32_t last = none;               // visible symbol on the path from the root
    std::uint32_t own = none;                // visible symbol on this axis
    std::vector<std::uint32_t> closed = {};  // last symbols of the branches that have been closed behind it
  };

  // Adds the pairs of one string: of the axiom, or of the successor of `production`.
  void collect_pairs(const std::vector<ModuleTree>& modules, const ProductionTree* production) {
    const std::uint32_t rewritten =
        production == nullptr ? none : symbols_.number(production->predecessor, production->system);
    std::vector<Level> levels(1);
    std::uint32_t first = none;
    for (const ModuleTree& module : modules) {
      Level& level = levels.back();
      if (module.name == "[") {
        levels.push_back({level.last, none});
      } else if (module.name == "]") {
        const std::uint32_t end = level.own;
        levels.pop_back();
        if (end != none) levels.back().closed.push_back(end);
      } else if (is_visible(module.name)) {
        const std::uint32_t symbol = symbols_.number(module.name, module.system);
        largest_symbol_ = std::max(largest_symbol_, symbol);
        if (level.last != none)
          left_.beside.push_back({level.last, symbol, module.place});
        else if (rewritten != none)
          left_.first.push_back({rewritten, symbol, module.place});
        for (const std::uint32_t end : level.closed) left_.add_bracketed(end, symbol, module.place);
        if (level.own != none)
          right_.beside.push_back({level.own, symbol, module.place});
        else if (levels.size() > 1 && level.last != none && levels[levels.size() - 2].own == level.last)
          right_.add_bracketed(level.last, symbol, module.place);
        if (levels.size() == 1 && first == none) first = symbol;
        level.last = level.own = symbol;
        level.closed.clear();
      }
    }
    if (production == nullptr) return;
    largest_symbol_ = std::max(largest_symbol_, rewritten);
    may_vanish_ |= first == none;
    if (first != none) right_.first.push_back({rewritten, first, production->place});
    if (first != none) last_.push_back({rewritten, levels[0].own, production->place});
  }

  const Grammar& grammar_;
  SymbolNumbers symbols_;
  std::vector<Remark> remarks_;
  Names listed_;  // by ignore: or consider:
  Side left_, right_;
  std::vector<Pair> last_;  // for each production: its symbol, and the last module of its successor
  std::uint32_t largest_symbol_ = 0;
  bool may_vanish_ = false;  // whether a successor has no visible module on its axis
};

}  // namespace

// Remarks on productions that can never apply, and on modules that no production fits.
std::vector<Remark> remarks_on_productions(const Grammar& grammar) { return ProductionChecker(grammar).run(); }

}  // namespace panicle::lsystem
