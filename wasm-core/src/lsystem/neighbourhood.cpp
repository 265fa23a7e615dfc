#include "lsystem/neighbourhood.hpp"

#include <cstring>

namespace panicle::lsystem {

bool Neighbourhood::begin(const String& string) {
  string_ = &string;
  at_ = path_length_ = open_count_ = 0;
  behind_ = nullptr;
  return path_.reserve(string.modules, string.modules) && (!program_.looks_right || find_ends());
}

// Where each branch ends, at the place of its bracket: so that looking past one costs the same whatever is on it.
bool Neighbourhood::find_ends() {
  if (!ends_.reserve(string_->used, string_->used)) return false;
  std::uint64_t open = 0;
  for (const std::uint32_t* at = string_->begin(); at < string_->end(); at += words_of(*at)) {
    const std::uint32_t symbol = symbol_of(*at);
    const auto offset = static_cast<std::uint32_t>(at - string_->begin());
    if (symbol == push_symbol) {
      if (!open_.reserve(open + 1, string_->modules)) return false;
      open_.data()[open++] = offset;
    } else if (symbol == pop_symbol) {
      ends_.data()[open_.data()[--open]] = offset;
    }
  }
  return true;
}

bool Neighbourhood::go_to(std::uint64_t at, std::uint64_t& looked) {
  const std::uint32_t* const words = string_->begin();
  looked += at - at_;
  while (at_ < at) {
    const std::uint32_t header = words[at_], symbol = symbol_of(header);
    if (symbol == push_symbol) {
      if (!open_.reserve(open_count_ + 1, string_->modules)) return false;
      open_.data()[open_count_++] = static_cast<std::uint32_t>(path_length_);
    } else if (symbol == pop_symbol) {
      path_length_ = open_.data()[--open_count_];
    } else if (is_seen(symbol)) {
      path_.data()[path_length_++] = static_cast<std::uint32_t>(at_);
    }
    at_ += words_of(header);
  }
  left_ = path_length_ > 0 ? symbol_of(words[path_.data()[path_length_ - 1]]) : no_symbol;
  if (!program_.looks_right) return true;
  behind_ = next_seen(words + at + words_of(words[at]), false, looked);
  right_ = behind_ != nullptr ? symbol_of(*behind_) : no_symbol;
  return true;
}

bool Neighbourhood::fits(const Production& production, float* registers, std::uint64_t& looked) {
  if (!fits_left(production.left, registers)) return false;
  const Range right = production.right;
  if (right.size() == 0) return true;
  const Neighbour& wanted = program_.neighbours[right.begin];
  if (right.size() == 1 && wanted.symbol != push_symbol) return behind_ != nullptr && is(wanted, behind_, registers);
  const std::uint32_t* const module = string_->begin() + at_;
  return follow(right.begin, right.end, module + words_of(*module), registers, looked) != nullptr;
}

bool Neighbourhood::fits_left(Range wanted, float* registers) const {
  if (wanted.size() > path_length_) return false;
  const std::uint32_t* const path = path_.data() + path_length_ - wanted.size();
  for (std::uint32_t i = 0; i < wanted.size(); ++i)
    if (!is(program_.neighbours[wanted.begin + i], string_->begin() + path[i], registers)) return false;
  return true;
}

// Follows neighbours along one axis from `at` on: where that ends, or null where it cannot be followed. A branch that
// is wanted has to begin as the one in the text does; branches that are not are passed over.
const std::uint32_t* Neighbourhood::follow(std::uint32_t begin, std::uint32_t end, const std::uint32_t* at,
                                           float* registers, std::uint64_t& looked) const {
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

// The next module of the axis that is seen, or, `into_branches`, the bracket of a branch before it; null where the axis
// ends.
const std::uint32_t* Neighbourhood::next_seen(const std::uint32_t* at, bool into_branches,
                                              std::uint64_t& looked) const {
  for (const std::uint32_t* const end = string_->end(); at < end; at += words_of(*at), ++looked) {
    const std::uint32_t symbol = symbol_of(*at);
    if (symbol == pop_symbol) return nullptr;
    if (symbol == push_symbol) {
      if (into_branches) return at;
      at = end_of_branch(at);
    } else if (is_seen(symbol)) {
      return at;
    }
  }
  return nullptr;
}

bool Neighbourhood::is(const Neighbour& wanted, const std::uint32_t* module, float* registers) const {
  if (symbol_of(*module) != wanted.symbol || parameters_of(*module) != wanted.arity) return false;
  std::memcpy(registers + wanted.to, module + 1, wanted.arity * sizeof(float));
  return true;
}

}  // namespace panicle::lsystem
