#include "lsystem/production_remarks.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "lsystem/names.hpp"
#include "lsystem/turtle_symbols.generated.hpp"

namespace panicle::lsystem {
namespace {

constexpr std::uint32_t none = Names::none;

// "no parameters", "1 parameter", "3 parameters".
std::string parameters(std::size_t count) {
  if (count == 0) return "no parameters";
  return std::to_string(count) + (count == 1 ? " parameter" : " parameters");
}

std::string line_of(const Place& place) { return std::to_string(place.line); }

// Numbers for symbols: one that is written the same in another L-system of the text is another.
class Symbols {
 public:
  std::uint32_t number(std::string_view name, std::uint32_t system) {
    key_.assign(name);
    if (system != 0 && name[0] != '?') key_.append("\x1f").append(std::to_string(system));
    return names_.add(key_);
  }

 private:
  Names names_;
  std::string key_;
};

// A number for each of the symbols, `otherwise` where none was set.
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

class Reader {
 public:
  explicit Reader(const Grammar& grammar) : grammar_(grammar) {}

  std::vector<Remark> run() {
    arities();
    order();
    contexts();
    return std::move(remarks_);
  }

 private:
  void add(const Place& place, const char* pattern, Pieces pieces) {
    remarks_.push_back({sentence(pattern, pieces), place.line, place.column});
  }

  // The turtle's symbols are drawn where nothing rewrites them.
  bool means_something(std::string_view name) const {
    return std::any_of(turtle_symbols.begin(), turtle_symbols.end(), [&](const TurtleSymbol& turtle) {
      return turtle.symbol == name && (!turtle.cpfg_only || grammar_.notation == Notation::cpfg);
    });
  }

  // Of a symbol: which numbers of parameters its modules have, and its productions, as bits; one of the productions.
  struct Arities {
    std::uint64_t written = 0, rewritten = 0, remarked = 0;
    const ProductionTree* first = nullptr;
  };

  template <class Each>
  void each_module(const Each& each) const {
    for (const ModuleTree& module : grammar_.axiom) each(module);
    for (const ProductionTree& production : grammar_.productions)
      for (const ModuleTree& module : production.successor) each(module);
  }

  void arities() {
    BySymbol<Arities> all;
    for (const ProductionTree& production : grammar_.productions) {
      Arities& of = all[symbols_.number(production.predecessor, production.system)];
      of.rewritten |= std::uint64_t{1} << production.arity;
      if (of.first == nullptr) of.first = &production;
    }
    each_module([&](const ModuleTree& module) {
      Arities& of = all[symbols_.number(module.name, module.system)];
      const std::uint64_t bit = std::uint64_t{1} << module.arguments.size();
      of.written |= bit;
      if (means_something(module.name)) return;
      if (of.rewritten == 0 || ((of.rewritten | of.remarked) & bit) != 0) return;
      of.remarked |= bit;
      const std::string line = line_of(of.first->place);
      add(module.place,
          "% has % here, but its production in line % has %, so this one is not rewritten; give it as many, or a "
          "production of its own.",
          {module.name, parameters(module.arguments.size()), line, parameters(of.first->arity)});
    });
    for (const ProductionTree& production : grammar_.productions) {
      const Arities& of = all[symbols_.number(production.predecessor, production.system)];
      const std::uint64_t bit = std::uint64_t{1} << production.arity;
      if (of.written == 0 || of.remarked != 0 || (of.written & bit) != 0 || production.predecessor[0] == '?') continue;
      add(production.place, "No % of this text has %, so this production is never used; write as many as the text has.",
          {production.predecessor, parameters(production.arity)});
    }
  }

  // What a production wants besides its symbol and number of parameters, as bytes: equal where two want the same. Empty
  // where it wants nothing.
  static std::string wanted_beside(const ProductionTree& production) {
    std::string bytes;
    for (const auto* side : {&production.left, &production.right}) {
      for (const NeighbourTree& neighbour : *side)
        bytes.append(neighbour.name).append("\x1f").append(std::to_string(neighbour.arity)).append("\x1e");
      if (!production.left.empty() || !production.right.empty()) bytes += '\x1d';
    }
    return bytes;
  }

  // Empty where the condition is a draw or follows a block: such a one is like no other.
  static std::string condition_bytes(const ProductionTree& production) {
    std::string bytes;
    for (const Node& node : production.condition.nodes) {
      if (node.kind == Node::Kind::operation && (is_random(node.op) || is_asked(node.op))) return {};
      char number[sizeof node.number];
      std::memcpy(number, &node.number, sizeof number);
      bytes += static_cast<char>('A' + static_cast<int>(node.kind));
      bytes.append(std::to_string(static_cast<int>(node.op))).append(number, sizeof number);
      bytes.append(std::to_string(node.curve)).append(name_bytes(production, node.name)).append("\x1e");
    }
    return production.before.empty() ? bytes : std::string();
  }

  // A formal by its place: it may be called otherwise in another production.
  static std::string name_bytes(const ProductionTree& production, std::string_view name) {
    for (std::size_t i = 0; i < production.formals.size(); ++i)
      if (production.formals[i].name == name) return "\x1f" + std::to_string(i);
    return std::string(name);
  }

  static bool has_weight(const ProductionTree& production) { return production.weight.given(); }
  // Whether it is one that chance cannot pass over for good.
  static bool weighs(const ProductionTree& production) {
    const std::vector<Node>& nodes = production.weight.nodes;
    return nodes.size() == 1 && nodes[0].kind == Node::Kind::number && nodes[0].number > 0;
  }

  // Of those that rewrite the same the first that matches decides; with a weight it competes with later ones that have
  // one as well (Machine::draw_production).
  void order() {
    Names keys;
    struct Earlier {
      std::uint32_t plain = none, weighted = none;  // lines
      bool alone = false;                           // whether none with a weight precedes the plain one
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
      const std::string beside = wanted_beside(production), condition = condition_bytes(production);
      const bool conditional = production.condition.given();
      const auto key = [&](const std::string& neighbours, const std::string& test) {
        return group + "\x1c" + neighbours + "\x1c" + test;
      };
      std::uint32_t line = none;
      const auto look = [&](const Earlier& of) {
        if (of.plain != none && (!has_weight(production) || of.alone)) line = of.plain;
        if (of.weighted != none && !has_weight(production)) line = of.weighted;
      };
      look(find(key({}, {})));
      if (!beside.empty()) look(find(key(beside, {})));
      if (!condition.empty()) look(find(key({}, condition)));
      if (!condition.empty() && !beside.empty()) look(find(key(beside, condition)));
      if (line != none)
        add(production.place,
            "This production is never used, since the one in line % applies before it wherever it could; move it up, "
            "or "
            "give both a weight, A --> B : 0.5.",
            {std::to_string(line)});
      if (has_weight(production)) has_weighted[group_number] = 1;
      if (conditional && (condition.empty() || is_number(production.condition))) continue;
      const std::uint32_t number = keys.add(key(beside, condition));
      if (number == earlier.size()) earlier.emplace_back();
      Earlier& of = earlier[number];
      if (has_weight(production)) {
        if (of.weighted == none && weighs(production)) of.weighted = production.place.line;
      } else if (of.plain == none) {
        of.plain = production.place.line;
        of.alone = has_weighted[group_number] == 0;
      }
    }
  }

  static bool is_number(const Expression& expression) {
    return expression.nodes.size() == 1 && expression.nodes[0].kind == Node::Kind::number;
  }

  // Two symbols beside each other in a string of the text, and a place.
  struct Pair {
    std::uint32_t before, after;
    Place place;
  };

  // What a context looks along: for a left one the way from the root, for a right one the axis of its module.
  struct Side {
    std::vector<Pair> beside;  // pairs that contexts see
    std::vector<Pair> first;   // of each production: its symbol, and one that its successor begins with
    // Pairs with a bracket between them that contexts do not look past, each once, and where it is first.
    Names bracketed;
    std::vector<Place> places;

    void add_bracketed(std::uint32_t before, std::uint32_t after, const Place& place) {
      if (bracketed.add(key(before, after)) == places.size()) places.push_back(place);
    }
    static std::string key(std::uint32_t before, std::uint32_t after) {
      return std::to_string(before) + ',' + std::to_string(after);
    }
  };

  // How productions that see neighbours could meet theirs. `[A] B`: A ends a branch before B; `A [B]`: B begins one
  // behind A.
  void contexts() {
    const bool any = std::any_of(grammar_.productions.begin(), grammar_.productions.end(), [](const auto& production) {
      return !production.left.empty() || !production.right.empty();
    });
    if (!any) return;
    for (const Named& symbol : grammar_.sight.symbols) listed_.add(symbol.name);
    string(grammar_.axiom, nullptr);
    for (const ProductionTree& production : grammar_.productions) string(production.successor, &production);
    if (vanishes_) return;  // what is between two modules may go
    std::size_t looked = 0;
    for (const ProductionTree& production : grammar_.productions) {
      const std::uint32_t symbol = symbols_.number(production.predecessor, production.system);
      if (!production.left.empty()) {
        const NeighbourTree& nearest = production.left.back();
        const std::uint32_t wanted = symbols_.number(nearest.name, production.system);
        if (const Place* const place = only_bracketed(left_, wanted, symbol, looked))
          add(nearest.place,
              "% stands before % only in a branch that is closed between them, in line %, and a left context does not "
              "look into it; write % before that bracket.",
              {nearest.name, production.predecessor, line_of(*place), nearest.name});
      }
      if (!production.right.empty() && production.right[0].name != "[") {
        const NeighbourTree& nearest = production.right[0];
        const std::uint32_t wanted = symbols_.number(nearest.name, production.system);
        if (const Place* const place = only_bracketed(right_, symbol, wanted, looked))
          add(nearest.place,
              "% stands behind % only in a branch, in line %, and a right context passes branches over; to look into "
              "it "
              "write % > [ % ].",
              {nearest.name, production.predecessor, line_of(*place), production.predecessor, nearest.name});
      }
    }
  }

  // Where two symbols stand with a bracket between them, if nowhere without one, whatever is rewritten.
  const Place* only_bracketed(const Side& side, std::uint32_t before, std::uint32_t after, std::size_t& looked) const {
    static constexpr std::size_t most_looks = 32;  // each goes through all pairs
    const std::uint32_t found = side.bracketed.find(Side::key(before, after));
    if (found == none || ++looked > most_looks) return nullptr;
    const std::vector<bool> may_end = reaching(last_, before), may_begin = reaching(side.first, after);
    for (const Pair& pair : side.beside)
      if (may_end[pair.before] && may_begin[pair.after]) return nullptr;
    return &side.places[found];
  }

  // By symbol: whether it is `symbol` or becomes it at that end, in any number of steps; all of them where that takes
  // long to find out.
  std::vector<bool> reaching(const std::vector<Pair>& becomes, std::uint32_t symbol) const {
    std::vector<bool> reaches(most_symbols_ + 1);
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

  bool is_seen(std::string_view name) const {
    const bool listed = listed_.find(name) != none;
    return grammar_.sight.kind == SightTree::Kind::consider ? listed : !listed;
  }

  // A level of brackets: the module that was seen last on the way to here, the one on this axis, and the ends of
  // branches that have been closed behind it.
  struct Level {
    std::uint32_t last = none, own = none;
    std::vector<std::uint32_t> closed = {};
  };

  void string(const std::vector<ModuleTree>& modules, const ProductionTree* production) {
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
      } else if (is_seen(module.name)) {
        const std::uint32_t symbol = symbols_.number(module.name, module.system);
        most_symbols_ = std::max(most_symbols_, symbol);
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
    most_symbols_ = std::max(most_symbols_, rewritten);
    vanishes_ |= first == none;
    if (first != none) right_.first.push_back({rewritten, first, production->place});
    if (first != none) last_.push_back({rewritten, levels[0].own, production->place});
  }

  const Grammar& grammar_;
  Symbols symbols_;
  std::vector<Remark> remarks_;
  Names listed_;  // by ignore: or consider:
  Side left_, right_;
  std::vector<Pair> last_;  // of each production: its symbol, and what its successor ends with
  std::uint32_t most_symbols_ = 0;
  bool vanishes_ = false;  // whether a successor has nothing that is seen on its axis
};

}  // namespace

std::vector<Remark> remarks_on_productions(const Grammar& grammar) { return Reader(grammar).run(); }

}  // namespace panicle::lsystem
