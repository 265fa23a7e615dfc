#include "lsystem/derivation/neighbourhood.hpp"

#include <cstring>

namespace panicle::lsystem {

// Classifies the symbols for the walk over the string: which of them contexts see, which have context-sensitive
// productions, and which open or close branches.
Neighbourhood::Neighbourhood(const Program& program)
    : program_(program), classes_(program.symbols.size(), passed_over) {
  for (std::size_t symbol = 0; symbol < classes_.size(); ++symbol) {
    const bool is_seen = program.passed_over[symbol] == 0, in_context = program.rules[symbol].in_context;
    if (is_seen) classes_[symbol] |= seen;
    if (in_context) classes_[symbol] |= context_sensitive;
    has_hidden_context_ |= in_context && !is_seen;
  }
  classes_[push_symbol] = opens;
  classes_[pop_symbol] = closes;
  wants_ends_ = program.looks_right && has_hidden_context_;
  for (const Production& production : program.productions) wants_ends_ |= production.right.size() > 1;
}

// Finds the neighbours in a string, which must not change until the next call. Returns false if there is no memory.
bool Neighbourhood::begin(const String& string) {
  string_ = &string;
  next_ = at_ = 0;
  if (program_.looks_far_left && !before_.reserve(string.used, string.used)) return false;
  if (wants_ends_ && !ends_.reserve(string.used, string.used)) return false;
  return walk();
}

// Finds the left and right neighbours of all context-sensitive modules in one walk. The next visible module behind a
// branch is also the right neighbour of the module before the branch. Returns false if there is no memory.
bool Neighbourhood::walk() {
  const std::uint32_t* const words = string_->begin();
  const auto used = static_cast<std::uint32_t>(string_->used);
  const std::uint8_t* const classes = classes_.data();
  std::uint32_t last = none;  // seen on the way from the root
  std::uint32_t pending =
      none;  // the entry of the last context-sensitive module, whose right neighbour is not known yet
  std::uint32_t places = 0, open = 0;
  for (std::uint32_t at = 0; at < used; at += words_of(words[at])) {
    const std::uint32_t symbol_class = classes[symbol_of(words[at])];
    if (symbol_class == passed_over) continue;
    if (symbol_class == opens) {
      if (!open_.reserve(open + walk_words, 3 * string_->modules)) return false;
      const std::uint32_t here[walk_words] = {at, last, pending};
      std::memcpy(open_.data() + open, here, sizeof here);
      open += walk_words;
      pending = none;
      continue;
    }
    if (symbol_class == closes) {
      std::uint32_t there[walk_words];
      open -= walk_words;
      std::memcpy(there, open_.data() + open, sizeof there);
      if (wants_ends_) ends_.data()[there[0]] = at;
      last = there[1];
      pending = there[2];
      continue;
    }
    if ((symbol_class & seen) != 0 && pending != none) places_.data()[pending + 2] = at;
    if ((symbol_class & context_sensitive) != 0) {
      if (!places_.reserve(places + place_words, 3 * string_->modules)) return false;
      const std::uint32_t here[place_words] = {at, last, none};
      std::memcpy(places_.data() + places, here, sizeof here);
    }
    if ((symbol_class & seen) != 0) {
      if (program_.looks_far_left) before_.data()[at] = last;
      last = at;
      pending = (symbol_class & context_sensitive) != 0 ? places : none;
    }
    if ((symbol_class & context_sensitive) != 0) places += place_words;
  }
  return true;
}

// Moves on to the context-sensitive module at a word; calls must be in ascending order. Adds the words that were passed
// to `looked`.
void Neighbourhood::go_to(std::uint64_t at, std::uint64_t& looked) {
  const std::uint32_t* const words = string_->begin();
  looked += at - at_;
  at_ = at;
  std::uint32_t there[place_words];
  do {
    std::memcpy(there, places_.data() + next_, sizeof there);
    next_ += place_words;
  } while (there[0] != at);
  before_it_ = there[1];
  behind_it_ = there[2];
  if (has_hidden_context_ && program_.looks_right) {
    const std::uint32_t* const behind = next_seen(words + at + words_of(words[at]), false, looked);
    behind_it_ = behind == nullptr ? none : static_cast<std::uint32_t>(behind - words);
  }
  left_ = kind_at(before_it_);
  right_ = kind_at(behind_it_);
}

// Whether a production's contexts match the current module; loads the neighbours' parameters into the registers. Adds
// the visited words to `looked`.
bool Neighbourhood::fits(const Production& production, Registers registers, std::uint64_t& looked) {
  if (!fits_left(production.left, registers)) return false;
  const Range right = production.right;
  if (right.size() == 0) return true;
  const Neighbour& wanted = program_.neighbours[right.begin];
  if (right.size() == 1) return behind_it_ != none && is(wanted, string_->begin() + behind_it_, registers);
  const std::uint32_t* const module = string_->begin() + at_;
  return follow(right.begin, right.end, module + words_of(*module), registers, looked) != nullptr;
}

// Whether the left neighbours match, from the nearest one towards the root.
bool Neighbourhood::fits_left(Range wanted, Registers registers) const {
  std::uint32_t place = before_it_;
  for (std::uint32_t i = wanted.end; i-- > wanted.begin;) {
    if (place == none || !is(program_.neighbours[i], string_->begin() + place, registers)) return false;
    if (i > wanted.begin) place = before_.data()[place];
  }
  return true;
}

// Matches neighbours along one axis from `at` on: returns the place behind them, or null where they do not match. A
// branch of the context has to begin as in the text; other branches are skipped.
const std::uint32_t* Neighbourhood::follow(std::uint32_t begin, std::uint32_t end, const std::uint32_t* at,
                                           Registers registers, std::uint64_t& looked) const {
  for (std::uint32_t i = begin; i < end; ++i) {
    const Neighbour& wanted = program_.neighbours[i];
    const bool branch = wanted.symbol == push_symbol;
    for (;;) {
      at = next_seen(at, branch, looked);
      if (at == nullptr || (symbol_of(*at) == push_symbol) != branch) return nullptr;
      if (!branch) break;
      const std::uint32_t* const inside = at + words_of(*at);
      const std::uint32_t* const closed = end_of_branch(at);
      ++looked;
      at = closed + words_of(*closed);
      if (follow(i + 1, wanted.closed, inside, registers, looked) != nullptr) break;
    }
    if (branch) {
      i = wanted.closed;
      continue;
    }
    looked += words_of(*at);
    if (!is(wanted, at, registers)) return nullptr;
    at += words_of(*at);
  }
  return at;
}

// Returns the next visible module of the axis, or, with `into_branches`, the bracket of a branch before it; null where
// the axis ends.
const std::uint32_t* Neighbourhood::next_seen(const std::uint32_t* at, bool into_branches,
                                              std::uint64_t& looked) const {
  for (const std::uint32_t* const end = string_->end(); at < end; at += words_of(*at), ++looked) {
    const std::uint32_t symbol = symbol_of(*at);
    if (symbol == pop_symbol) return nullptr;
    if (symbol == push_symbol) {
      if (into_branches) return at;
      at = end_of_branch(at);
    } else if ((classes_[symbol] & seen) != 0) {
      return at;
    }
  }
  return nullptr;
}

// Whether a module has the wanted symbol and number of parameters; if so, loads its parameters.
bool Neighbourhood::is(const Neighbour& wanted, const std::uint32_t* module, Registers registers) const {
  if (symbol_of(*module) != wanted.symbol || parameters_of(*module) != wanted.arity) return false;
  if (registers.precise != nullptr) {
    std::memcpy(registers.precise + wanted.to, doubles_of(module), wanted.arity * sizeof(double));
  } else {
    std::memcpy(registers.single + wanted.to, module + 1, wanted.arity * sizeof(float));
  }
  return true;
}

}  // namespace panicle::lsystem
