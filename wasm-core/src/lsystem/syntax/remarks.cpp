#include "lsystem/syntax/remarks.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "expression/messages.generated.hpp"
#include "expression/names.hpp"
#include "lsystem/derivation/program.hpp"
#include "lsystem/messages.generated.hpp"
#include "lsystem/syntax/production_remarks.hpp"

namespace panicle::lsystem {

// The turtle is the moving pen that draws a string.

namespace {

constexpr std::string_view turns = "+-&^/\\<>";
constexpr std::string_view angle_names[] = {"angle", "delta", "δ"};

// Reader of a grammar that collects remarks: notes on passages that are allowed but probably not meant.
class Reader {
 public:
  explicit Reader(const Grammar& grammar) : grammar_(grammar) {}

  // Collects remarks on passages that are allowed but probably not meant, in the order of the text.
  std::vector<Remark> run() {
    for (const ProductionTree& production : grammar_.productions) known_.add(production.predecessor);
    for (const TurtleSymbol& turtle : turtle_symbols)
      if (!turtle.cpfg_only || grammar_.notation == Notation::cpfg) known_.add(turtle.symbol);
    note_uses();
    string(grammar_.axiom, 0);
    on_axiom_.swap(remarks_);
    for (const ProductionTree& production : grammar_.productions) {
      if (grammar_.axiom[0].place.line < production.place.line) add_those_on_axiom();
      if (production.predecessor == "S" && grammar_.notation == Notation::huang)
        once("S as a symbol", production.place, message(messages::lsystem::remark_sphere));
      if (production.condition.nodes.size() == 1 && production.condition.nodes[0].kind == Node::Kind::number)
        once("one number", production.condition.place, message(messages::lsystem::remark_constant_condition));
      string(production.successor, production.place.line);
    }
    add_those_on_axiom();
    return std::move(remarks_);
  }

 private:
  // Adds a remark, unless one of the same kind was added before.
  void once(std::string_view what, const SourceLocation& place, const Message& problem) {
    const std::uint32_t number = reported_.size();
    if (reported_.add(what) == number) remarks_.push_back({problem, place.line, place.column});
  }

  // Inserts the remarks on the axiom at its place in the text; they are found before all others.
  void add_those_on_axiom() {
    for (Remark& remark : on_axiom_) remarks_.push_back(std::move(remark));
    on_axiom_.clear();
  }

  // Whether a symbol is the turtle's or is rewritten by a production.
  bool is_known(std::string_view symbol) const { return known_.find(symbol) != Names::none; }

  // Notes an unused constant that a reader would take for the angle of turns without arguments.
  void note_uses() {
    bool used[std::size(angle_names)] = {};
    const auto use = [&](const Expression& expression) {
      for (const Node& node : expression.nodes)
        for (std::size_t i = 0; i < std::size(angle_names); ++i) used[i] |= node.name == angle_names[i];
    };
    const auto use_all = [&](const std::vector<ModuleTree>& modules) {
      for (const ModuleTree& module : modules)
        for (const Expression& argument : module.arguments) use(argument);
    };
    use_all(grammar_.axiom);
    for (const Expression& setting : grammar_.settings) use(setting);
    for (const DefinitionTree& definition : grammar_.definitions)
      for (const Expression& value : definition.values) use(value);
    for (const ProductionTree& production : grammar_.productions) {
      use_all(production.successor);
      use(production.condition);
      use(production.weight);
      for (const AssignmentTree& assignment : production.before) use(assignment.expression);
      for (const AssignmentTree& assignment : production.after) use(assignment.expression);
    }
    for (const DefinitionTree& definition : grammar_.definitions)
      for (std::size_t i = 0; i < std::size(angle_names); ++i)
        if (definition.name == angle_names[i] && !used[i]) angle_ = angle_names[i];
  }

  // Collects the remarks on a string of modules. `line` is that of the arrow before it; 0 for none.
  void string(const std::vector<ModuleTree>& modules, std::uint32_t line) {
    for (std::size_t i = 0; i < modules.size(); ++i) {
      module(modules[i]);
      const bool begins_line = (i == 0 ? line : modules[i - 1].place.line) != modules[i].place.line;
      if (begins_line && reads_as_comment(modules, i))
        once("//", modules[i].place, message(messages::lsystem::remark_comment));
      if (begins_line && i > 0 && reads_as_words(modules, i))
        once("words", modules[i].place, message(messages::lsystem::remark_words));
    }
  }

  // Collects the remarks on one module.
  void module(const ModuleTree& module) {
    if (module.arguments.empty()) bare(module);
    if (!is_known(module.name)) unknown(module);
  }

  // Whether the text sets a global setting.
  bool is_set(GlobalSetting which) const { return grammar_.settings[static_cast<std::size_t>(which)].given(); }

  // Remarks on the default of an omitted argument, once, unless the text sets it.
  void bare(const ModuleTree& module) {
    const bool cpfg = grammar_.notation == Notation::cpfg;
    if (module.name == "!" && !cpfg) once("!", module.place, message(messages::lsystem::remark_width));
    if ((module.name == "!" || module.name == "#") && cpfg && !is_set(GlobalSetting::line_width_increment))
      once("!", module.place, message(messages::lsystem::remark_width_increment, module.name));
    if (module.name.size() != 1 || turns.find(module.name[0]) == std::string_view::npos ||
        is_set(GlobalSetting::angle_increment))
      return;
    if (!angle_.empty())
      once("angle", module.place, message(messages::lsystem::remark_angle_unused, module.name, angle_));
    else if (cpfg)
      once("angle", module.place, message(messages::lsystem::remark_angle, module.name));
  }

  // Notes a symbol that no production rewrites and the turtle does not know.
  void unknown(const ModuleTree& module) {
    const std::string_view name = module.name, digits = name.substr(1);
    const bool turtles = name[0] == 'F' || name[0] == 'f' || name[0] == 'S';
    if (turtles && !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos)
      once(name, module.place, message(messages::lsystem::remark_digits, name, name.substr(0, 1), digits));
    const bool capitals = name.size() > 1 && name.find_first_not_of("FGABCDLRXYIJKPQ") == std::string_view::npos;
    if (capitals && name.find('F') != std::string_view::npos)
      once(name, module.place, message(messages::lsystem::remark_run_together, name));
    if ((name == "G" || name == "g") && !module.arguments.empty())
      once(name, module.place, message(messages::lsystem::remark_cpfg_only, name));
  }

  // Whether modules read as a comment: `//` and at least two words without meaning.
  bool reads_as_comment(const std::vector<ModuleTree>& modules, std::size_t at) const {
    if (at + 3 >= modules.size() || modules[at].name != "/" || modules[at + 1].name != "/") return false;
    return std::all_of(modules.begin() + static_cast<std::ptrdiff_t>(at),
                       modules.begin() + static_cast<std::ptrdiff_t>(at) + 4,
                       [&](const ModuleTree& module) {
                         return module.arguments.empty() && module.place.line == modules[at].place.line &&
                                (module.name == "/" || !is_known(module.name));
                       }) &&
           modules[at + 2].name != "/" && modules[at + 3].name != "/";
  }

  // Whether a line reads as words: nothing but names without meaning, two of them or a long one.
  bool reads_as_words(const std::vector<ModuleTree>& modules, std::size_t at) const {
    constexpr std::size_t least = 4, long_word = 8;
    std::size_t letters = 0, words = 0;
    for (const std::uint32_t line = modules[at].place.line; at < modules.size() && modules[at].place.line == line;
         ++at) {
      const ModuleTree& module = modules[at];
      if (!module.arguments.empty() || module.name.size() < least || is_known(module.name)) return false;
      letters += module.name.size();
      ++words;
    }
    return words > 1 || letters >= long_word;
  }

  const Grammar& grammar_;
  Names known_;  // by the turtle or a production
  Names reported_;
  std::string_view angle_;
  std::vector<Remark> remarks_;
  std::vector<Remark> on_axiom_;
};

// The names that a program defines.
Names declared_by(const Program& program) {
  Names names;
  for (const Declaration& declaration : program.declarations) names.add(declaration.name);
  return names;
}

}  // namespace

// All remarks on a grammar, in the order of the text.
std::vector<Remark> remarks_on(const Grammar& grammar) {
  std::vector<Remark> all = Reader(grammar).run();
  for (Remark& remark : remarks_on_productions(grammar)) all.push_back(std::move(remark));
  std::stable_sort(all.begin(), all.end(), [](const Remark& one, const Remark& other) {
    return one.line < other.line || (one.line == other.line && one.column < other.column);
  });
  return all;
}

// The remarks on a program, and on inputs that it does not have.
std::vector<Remark> remarks(const Program& program, std::span<const Inputs::Scalar> requested,
                            std::optional<std::uint32_t> steps) {
  std::vector<Remark> all = program.remarks;
  for (const Production& production : program.productions)
    if (production.by_chance && !steps && !program.steps.given)
      all.push_back({message(messages::lsystem::remark_random_condition, program.symbols[production.predecessor]),
                     production.place.line, production.place.column});
  const Names declared = requested.empty() ? Names() : declared_by(program);
  for (const Inputs::Scalar& given : requested)
    if (declared.find(given.name) == Names::none)
      all.push_back({message(messages::lsystem::remark_unknown_parameter, given.name), 0, 0});
  return all;
}

// A remark with its place, as text.
std::string to_text(const Remark& remark) {
  if (remark.line == 0) return remark.message;
  return message(messages::expression::at_line_and_column, remark.line, remark.column, remark.message);
}

}  // namespace panicle::lsystem
