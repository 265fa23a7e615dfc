#include "lsystem/trace/refusals.hpp"

#include "expression/code.hpp"
#include "expression/messages.generated.hpp"
#include "expression/number_text.hpp"
#include "expression/token_reader.hpp"
#include "lsystem/messages.generated.hpp"

namespace panicle::lsystem {

// Prepares to explain why productions do not rewrite modules of a string, in a step if its number is given. `answered`:
// whether queries have responses.
Refusals::Refusals(const BoundProgram& bound, std::uint64_t seed, const Limits& limits, const Space* space,
                   const String& string, std::optional<std::uint32_t> step, bool answered)
    : program_(*bound.program),
      machine_(bound, seed, limits, space),
      neighbourhood_(program_),
      string_(string),
      answered_(answered) {
  if (step) machine_.decide_at(*step);
  machine_.look_around(neighbourhood_);
  has_neighbours_ = program_.in_context && neighbourhood_.begin(string);
}

// The reasons, by production, why the module at a word is not rewritten by it.
std::vector<Refusal> Refusals::of(std::uint64_t at) {
  const std::uint32_t* const module = string_.begin() + at;
  const Rules& rules = program_.rules[symbol_of(*module)];
  std::vector<Refusal> all;
  if (machine_.failed() || rules.productions.size() == 0 || (rules.in_context && !has_neighbours_)) return all;
  std::uint64_t visited = 0;
  if (rules.in_context) neighbourhood_.go_to(at, visited);
  if (symbol_of(*module) == query_symbol && !answered_) return all;
  const Production* const chosen = machine_.choose(module);
  for (std::uint32_t i = rules.productions.begin; i < rules.productions.end && all.size() < most; ++i) {
    const Production& production = program_.productions[i];
    if (&production == chosen) continue;
    const Machine::Obstacle obstacle = machine_.obstacle_of(production, module);
    if (machine_.failed()) return {};
    std::string reason = reason_for(production, obstacle, module);
    if (obstacle == Machine::Obstacle::none && chosen != nullptr)
      reason = message(production.weight.given && chosen->weight.given ? messages::lsystem::refusal_drawn
                                                                       : messages::lsystem::refusal_first,
                       chosen->place.line);
    if (!reason.empty()) all.push_back({production.place, std::move(reason)});
  }
  return all;
}

// The reason, in words, why a production does not rewrite a module; empty for none.
std::string Refusals::reason_for(const Production& production, Machine::Obstacle obstacle,
                                 const std::uint32_t* module) {
  switch (obstacle) {
    case Machine::Obstacle::parameters:
      return message(messages::lsystem::refusal_parameters,
                     message(messages::expression::term_parameters, production.arity),
                     message(messages::expression::term_parameters, parameters_of(*module)));
    case Machine::Obstacle::context:
      return context_mismatch(production, module);
    case Machine::Obstacle::condition: {
      const std::string values = values_of(production);
      return values.empty() ? message(messages::lsystem::refusal_condition)
                            : message(messages::lsystem::refusal_condition_values, values);
    }
    case Machine::Obstacle::none:
      break;
  }
  return {};
}

// How the nearest neighbours differ from those that the context requires; where they match, a neighbour farther away
// differs.
std::string Refusals::context_mismatch(const Production& production, const std::uint32_t* module) {
  const auto mismatch = [&](bool left, const Neighbour& wanted, std::uint32_t actual) -> std::string {
    const std::string_view name = program_.symbols[wanted.symbol];
    const auto at = static_cast<std::uint64_t>(module - string_.begin());
    if (actual == Neighbour::kind(header_of(wanted.symbol, wanted.arity, 0, program_.code.doubles))) return {};
    if (actual != Neighbour::any && symbol_of(actual) == wanted.symbol)
      return message(left ? messages::lsystem::refusal_left_parameters : messages::lsystem::refusal_right_parameters,
                     name, message(messages::expression::term_parameters, parameters_of(actual)),
                     message(messages::expression::term_parameters, wanted.arity));
    if (!left && begins_branch(module, wanted.symbol)) return message(messages::lsystem::refusal_right_in_branch, name);
    if (left && ends_branch(at, wanted.symbol)) return message(messages::lsystem::refusal_left_in_branch, name);
    if (actual == Neighbour::any)
      return message(left ? messages::lsystem::refusal_left_missing : messages::lsystem::refusal_right_missing, name);
    return message(left ? messages::lsystem::refusal_left_other : messages::lsystem::refusal_right_other,
                   program_.symbols[symbol_of(actual)], name);
  };
  const Range left = production.left, right = production.right;
  if (left.size() > 0) {
    std::string reason = mismatch(true, program_.neighbours[left.end - 1], neighbourhood_.left());
    if (!reason.empty()) return reason;
  }
  if (right.size() > 0 && program_.neighbours[right.begin].symbol != push_symbol) {
    std::string reason = mismatch(false, program_.neighbours[right.begin], neighbourhood_.right());
    if (!reason.empty()) return reason;
  }
  return message(messages::lsystem::refusal_context);
}

// The values of the parameters that a production was tried with: `x = 3, y = 0.5`.
std::string Refusals::values_of(const Production& production) const {
  const Range names = program_.named_in[static_cast<std::size_t>(&production - program_.productions.data())];
  std::string text;
  for (std::uint32_t i = names.begin; i < names.end; ++i) {
    const Naming& naming = program_.namings[i];
    if (naming.source >= max_parameters) break;  // values that blocks compute follow
    if (!text.empty()) text += ", ";
    text += naming.name + " = " + number_text(machine_.value_of(naming.source));
  }
  return text;
}

// Whether contexts match the symbol: `ignore:` and `consider:` hide others.
bool Refusals::is_visible(std::uint32_t symbol) const { return program_.passed_over[symbol] == 0; }

// Whether one of the branches right behind the module begins with the symbol, not counting hidden symbols.
bool Refusals::begins_branch(const std::uint32_t* module, std::uint32_t symbol) {
  std::uint32_t open = 0;
  bool begins = false;
  for (const std::uint32_t* at = module + words_of(*module); at < string_.end() && may_visit(); at += words_of(*at)) {
    const std::uint32_t current = symbol_of(*at);
    if (current == push_symbol) {
      begins = open == 0;
      ++open;
    } else if (current == pop_symbol) {
      if (open == 0) return false;
      --open;
      begins = false;
    } else if (is_visible(current)) {
      if (open == 0) return false;
      if (begins && current == symbol) return true;
      begins = false;
    }
  }
  return false;
}

// Whether one of the branches that are closed right before the module ends with the symbol, not counting hidden
// symbols.
bool Refusals::ends_branch(std::uint64_t at, std::uint32_t symbol) {
  struct Level {
    std::uint32_t last = no_symbol;  // the visible symbol read last
    bool branch_ends_so = false;     // whether a branch that was closed behind `last` ends with the symbol
  };
  std::vector<Level> levels(1);
  const std::uint32_t* const module = string_.begin() + at;
  for (const std::uint32_t* word = string_.begin(); word < module; word += words_of(*word)) {
    if (!may_visit()) return false;
    const std::uint32_t current = symbol_of(*word);
    if (current == push_symbol) {
      levels.emplace_back();
    } else if (current == pop_symbol) {
      const std::uint32_t last = levels.back().last;
      levels.pop_back();
      levels.back().branch_ends_so |= last == symbol;
    } else if (is_visible(current)) {
      levels.back() = {current, false};
    }
  }
  return levels.back().branch_ends_so;
}

}  // namespace panicle::lsystem
