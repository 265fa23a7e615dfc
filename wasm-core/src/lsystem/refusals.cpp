#include "lsystem/refusals.hpp"

#include "lsystem/number_text.hpp"
#include "lsystem/token_reader.hpp"

namespace panicle::lsystem {
namespace {

std::string parameters(std::uint32_t count) {
  if (count == 0) return "no parameters";
  return std::to_string(count) + (count == 1 ? " parameter" : " parameters");
}

}  // namespace

Refusals::Refusals(const Bound& bound, std::uint64_t seed, const Limits& limits, const Space* space,
                   const String& string, std::optional<std::uint32_t> step, bool answered)
    : program_(*bound.program),
      machine_(bound, seed, limits, space),
      neighbourhood_(program_),
      string_(string),
      answered_(answered) {
  if (step) machine_.decide_at(*step);
  machine_.look_around(neighbourhood_);
  sees_ = program_.in_context && neighbourhood_.begin(string);
}

std::vector<Refusal> Refusals::of(std::uint64_t at) {
  const std::uint32_t* const module = string_.begin() + at;
  const Rules& rules = program_.rules[symbol_of(*module)];
  std::vector<Refusal> all;
  if (machine_.failed() || rules.productions.size() == 0 || (rules.in_context && !sees_)) return all;
  std::uint64_t looked = 0;
  if (rules.in_context) neighbourhood_.go_to(at, looked);
  if (symbol_of(*module) == ask_symbol && !answered_) return all;
  const Production* const chosen = machine_.choose(module);
  for (std::uint32_t i = rules.productions.begin; i < rules.productions.end && all.size() < most; ++i) {
    const Production& production = program_.productions[i];
    if (&production == chosen) continue;
    const Machine::Obstacle obstacle = machine_.obstacle_of(production, module);
    if (machine_.failed()) return {};
    std::string reason = why(production, obstacle, module);
    if (obstacle == Machine::Obstacle::none && chosen != nullptr)
      reason = sentence(production.weight.given && chosen->weight.given ? "chance drew the production in line %"
                                                                        : "the production in line % comes first",
                        {std::to_string(chosen->place.line)});
    if (!reason.empty()) all.push_back({production.place, std::move(reason)});
  }
  return all;
}

std::string Refusals::why(const Production& production, Machine::Obstacle obstacle, const std::uint32_t* module) {
  switch (obstacle) {
    case Machine::Obstacle::parameters:
      return sentence("it is for %, and the module has %",
                      {parameters(production.arity), parameters(parameters_of(*module))});
    case Machine::Obstacle::context:
      return why_not_beside(production, module);
    case Machine::Obstacle::condition: {
      const std::string values = values_of(production);
      return sentence(values.empty() ? "its condition is false" : "its condition is false with %", {values});
    }
    case Machine::Obstacle::none:
      break;
  }
  return {};
}

// What stands beside the module, where that is not what the context begins with; else that it goes on otherwise.
std::string Refusals::why_not_beside(const Production& production, const std::uint32_t* module) {
  const auto beside = [&](bool left, const Neighbour& wanted, std::uint32_t there) -> std::string {
    const std::string_view name = program_.symbols[wanted.symbol];
    const std::string_view where = left ? "before" : "behind";
    const auto at = static_cast<std::uint64_t>(module - string_.begin());
    if (there == Neighbour::kind(header_of(wanted.symbol, wanted.arity, 0, program_.code.doubles))) return {};
    if (there != Neighbour::any && symbol_of(there) == wanted.symbol)
      return sentence("the % % it has %, not %",
                      {name, where, parameters(parameters_of(there)), parameters(wanted.arity)});
    if (!left && heads_a_branch(module, wanted.symbol))
      return sentence("the % behind it stands in a branch; to look into it write > [ % ]", {name, name});
    if (left && ends_a_branch(at, wanted.symbol))
      return sentence("the % before it stands in a branch that is closed, where a left context does not look", {name});
    if (there == Neighbour::any) return sentence("nothing stands % it where % should", {where, name});
    return sentence("% stands % it, not %", {program_.symbols[symbol_of(there)], where, name});
  };
  const Range left = production.left, right = production.right;
  if (left.size() > 0) {
    std::string reason = beside(true, program_.neighbours[left.end - 1], neighbourhood_.left());
    if (!reason.empty()) return reason;
  }
  if (right.size() > 0 && program_.neighbours[right.begin].symbol != push_symbol) {
    std::string reason = beside(false, program_.neighbours[right.begin], neighbourhood_.right());
    if (!reason.empty()) return reason;
  }
  return "what stands around it is another context";
}

// `x = 3, y = 0.5`: of the parameters that it was tried with.
std::string Refusals::values_of(const Production& production) const {
  const Range names = program_.named_in[static_cast<std::size_t>(&production - program_.productions.data())];
  std::string text;
  for (std::uint32_t i = names.begin; i < names.end; ++i) {
    const Naming& naming = program_.namings[i];
    if (naming.source >= most_parameters) break;  // what a block works out
    if (!text.empty()) text += ", ";
    text += naming.name + " = " + number_text(machine_.value_of(naming.source));
  }
  return text;
}

bool Refusals::is_seen(std::uint32_t symbol) const { return program_.passed_over[symbol] == 0; }

// Whether one of the branches right behind the module begins with the symbol, as far as contexts see.
bool Refusals::heads_a_branch(const std::uint32_t* module, std::uint32_t symbol) {
  std::uint32_t open = 0;
  bool begins = false;
  for (const std::uint32_t* at = module + words_of(*module); at < string_.end() && looks_on(); at += words_of(*at)) {
    const std::uint32_t here = symbol_of(*at);
    if (here == push_symbol) {
      begins = open == 0;
      ++open;
    } else if (here == pop_symbol) {
      if (open == 0) return false;
      --open;
      begins = false;
    } else if (is_seen(here)) {
      if (open == 0) return false;
      if (begins && here == symbol) return true;
      begins = false;
    }
  }
  return false;
}

// Whether one of the branches that are closed right before the module ends with the symbol, as far as contexts see.
bool Refusals::ends_a_branch(std::uint64_t at, std::uint32_t symbol) {
  struct Level {
    std::uint32_t last = no_symbol;
    bool ends_so = false;
  };
  std::vector<Level> levels(1);
  const std::uint32_t* const module = string_.begin() + at;
  for (const std::uint32_t* word = string_.begin(); word < module; word += words_of(*word)) {
    if (!looks_on()) return false;
    const std::uint32_t here = symbol_of(*word);
    if (here == push_symbol) {
      levels.emplace_back();
    } else if (here == pop_symbol) {
      const std::uint32_t last = levels.back().last;
      levels.pop_back();
      levels.back().ends_so |= last == symbol;
    } else if (is_seen(here)) {
      levels.back() = {here, false};
    }
  }
  return levels.back().ends_so;
}

}  // namespace panicle::lsystem
