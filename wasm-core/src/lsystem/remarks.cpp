#include "lsystem/remarks.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "lsystem/program.hpp"

namespace panicle::lsystem {
namespace {

constexpr std::string_view angle_names[] = {"angle", "delta", "δ"};

class Reader {
 public:
  explicit Reader(const Grammar& grammar) : grammar_(grammar) {}

  std::vector<Remark> run() {
    for (const ProductionTree& production : grammar_.productions) known_.insert(production.predecessor);
    for (const TurtleSymbol& turtle : turtle_symbols) known_.insert(turtle.symbol);
    note_uses();
    string(grammar_.axiom, 0);
    for (const ProductionTree& production : grammar_.productions) {
      if (production.predecessor == "S")
        once(
            "S as a symbol", production.place,
            {"S is the turtle's sphere and is drawn where no production rewrites it; give a symbol of your own another "
             "name."});
      string(production.successor, production.place.line);
    }
    std::stable_sort(remarks_.begin(), remarks_.end(), [](const Remark& a, const Remark& b) {
      return std::pair(a.line, a.column) < std::pair(b.line, b.column);
    });
    return std::move(remarks_);
  }

 private:
  void once(std::string_view what, const Place& place, Pieces pieces) {
    if (said_.insert(what).second) remarks_.push_back({joined(pieces), place.line, place.column});
  }

  // Which constant a reader takes for the angle of bare turns: one that nothing uses.
  void note_uses() {
    std::set<std::string_view> used;
    const auto use = [&](const Expression& expression) {
      for (const Node& node : expression.nodes) used.insert(node.name);
    };
    const auto use_all = [&](const std::vector<ModuleTree>& modules) {
      for (const ModuleTree& module : modules)
        for (const Expression& argument : module.arguments) use(argument);
    };
    use_all(grammar_.axiom);
    for (const DefinitionTree& definition : grammar_.definitions) use(definition.expression);
    for (const ProductionTree& production : grammar_.productions) {
      use_all(production.successor);
      if (production.condition) use(*production.condition);
      if (production.weight) use(*production.weight);
    }
    for (const DefinitionTree& definition : grammar_.definitions)
      for (const std::string_view name : angle_names)
        if (definition.name == name && !used.contains(name)) angle_ = name;
  }

  // `line` is where an arrow stands, behind which the string begins; 0 for none.
  void string(const std::vector<ModuleTree>& modules, std::uint32_t line) {
    for (std::size_t i = 0; i < modules.size(); ++i) {
      module(modules[i]);
      const bool begins_line = (i == 0 ? line : modules[i - 1].place.line) != modules[i].place.line;
      if (begins_line && reads_as_comment(modules, i))
        once("//", modules[i].place,
             {"This line is read as two rolls of the turtle and symbols that draw nothing; a comment is written /* … "
              "*/."});
    }
  }

  void module(const ModuleTree& module) {
    const bool bare = module.arguments.empty();
    if (bare && module.name == "!")
      once("!", module.place, {"! without an argument sets the width to 1; in cpfg it narrows the lines: write !(w)."});
    if (bare && !angle_.empty() &&
        (module.name == "+" || module.name == "-" || module.name == "&" || module.name == "^"))
      once("angle", module.place,
           {module.name, " without an argument turns by 90° and does not heed '", angle_, "'; write ", module.name, "(",
            angle_, ")."});
    if (!known_.contains(module.name)) unknown(module);
  }

  // A symbol that nothing rewrites and the turtle does not know.
  void unknown(const ModuleTree& module) {
    const std::string_view name = module.name, digits = name.substr(1);
    const bool turtles = name[0] == 'F' || name[0] == 'f' || name[0] == 'S';
    if (turtles && !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos)
      once(name, module.place,
           {name, " is one symbol of its own and draws nothing; write ", name.substr(0, 1), "(", digits, ")."});
    if (name == "T")
      once(name, module.place, {"T draws nothing; in cpfg it bends what follows (tropism), which the notation lacks."});
    if ((name == "G" || name == "g") && !module.arguments.empty())
      once(name, module.place, {name, " draws nothing; in cpfg it moves ahead within a polygon: write F or f."});
  }

  // `//` and at least two words that mean nothing.
  bool reads_as_comment(const std::vector<ModuleTree>& modules, std::size_t at) const {
    if (at + 3 >= modules.size() || modules[at].name != "/" || modules[at + 1].name != "/") return false;
    return std::all_of(modules.begin() + static_cast<std::ptrdiff_t>(at),
                       modules.begin() + static_cast<std::ptrdiff_t>(at) + 4,
                       [&](const ModuleTree& module) {
                         return module.arguments.empty() && module.place.line == modules[at].place.line &&
                                (module.name == "/" || !known_.contains(module.name));
                       }) &&
           modules[at + 2].name != "/" && modules[at + 3].name != "/";
  }

  const Grammar& grammar_;
  std::set<std::string_view> known_;  // by the turtle or a production
  std::set<std::string_view> said_;
  std::string_view angle_;
  std::vector<Remark> remarks_;
};

bool declares(const Program& program, std::string_view name) {
  return std::any_of(program.declarations.begin(), program.declarations.end(),
                     [&](const Declaration& declaration) { return declaration.name == name; });
}

}  // namespace

std::vector<Remark> remarks_on(const Grammar& grammar) { return Reader(grammar).run(); }

std::vector<Remark> remarks(const Program& program, std::span<const Inputs::Scalar> asked,
                            std::optional<std::uint32_t> steps) {
  std::vector<Remark> all = program.remarks;
  for (const Production& production : program.productions)
    if (production.by_chance && !steps && !program.steps.given)
      all.push_back({joined({program.symbols[production.predecessor],
                             " tries its random condition once; with a derivation length it is tried each step."}),
                     production.place.line, production.place.column});
  for (const Inputs::Scalar& given : asked)
    if (!declares(program, given.name))
      all.push_back({joined({"The grammar has no #define ", given.name, ", so its parameter changes nothing."}), 0, 0});
  return all;
}

std::string to_text(const Remark& remark) {
  if (remark.line == 0) return remark.message;
  return joined(
      {"Line ", std::to_string(remark.line), ", column ", std::to_string(remark.column), ": ", remark.message});
}

}  // namespace panicle::lsystem
