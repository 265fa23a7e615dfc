// The end of the branch that a % cuts: the one implementation of nested brackets.
#pragma once

#include <cstdint>

#include "lsystem/derivation/program.hpp"
#include "lsystem/derivation/words.hpp"

namespace panicle::lsystem {

// Follows the modules behind a % to the bracket that closes its branch.
class BranchEnd {
 public:
  // Whether the next module is that bracket.
  bool reached(std::uint32_t symbol) {
    if (symbol == push_symbol) ++open_;
    return symbol == pop_symbol && open_-- == 0;
  }

 private:
  std::uint64_t open_ = 0;
};

// The rest of the branch from `at` on: up to the bracket that closes it, or to `end`.
struct RestOfBranch {
  const std::uint32_t* end;
  std::uint64_t modules;
};

// Skips the modules of a branch from `at` to its closing bracket, or to `end`.
inline RestOfBranch rest_of_branch(const std::uint32_t* at, const std::uint32_t* end) {
  BranchEnd closing;
  std::uint64_t modules = 0;
  for (; at < end && !closing.reached(symbol_of(*at)); at += words_of(*at)) ++modules;
  return {at, modules};
}

}  // namespace panicle::lsystem
