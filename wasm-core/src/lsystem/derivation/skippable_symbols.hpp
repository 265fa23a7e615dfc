// Modules that a walk of the turtle can skip: those without a turtle command and, where the listener gets no events,
// those that leave the turtle unchanged, and branches without turtle queries.
#pragma once

#include <cstdint>
#include <vector>

#include "lsystem/derivation/program.hpp"
#include "lsystem/derivation/words.hpp"

namespace panicle::lsystem {

class SkippableSymbols {
 public:
  // `images` are the homomorphism rules by symbol, null for none; they and `program` must outlive it.
  SkippableSymbols(const Program& program, const Rules* images, bool heard);

  // Whether every module of a symbol can be skipped.
  bool covers(std::uint32_t symbol) const { return quiet_[symbol] != 0; }

  // Finds the branches of a string without turtle queries, for a walk without events.
  void find_branches(const String& string);
  // Returns the place behind the branches that begin at `at`. Call it in the order of the string.
  const std::uint32_t* behind_branches(const String& string, const std::uint32_t* at) {
    std::uint64_t offset = static_cast<std::uint64_t>(at - string.begin());
    for (; next_branch_ < branches_.size() && branches_[next_branch_].begin <= offset; ++next_branch_)
      if (branches_[next_branch_].begin == offset) offset = branches_[next_branch_].end;
    return string.begin() + offset;
  }

 private:
  // A branch without turtle queries: words from its [ to behind its ].
  struct Branch {
    std::uint64_t begin, end;
  };

  // Whether an interpretation rule replaces the symbol when it is drawn.
  bool has_image(std::uint32_t symbol) const { return images_ != nullptr && images_[symbol].productions.size() > 0; }
  bool means(std::uint32_t symbol, bool (*what)(Action)) const;
  bool comes_back(const Template& image) const;

  const Program& program_;
  const Rules* images_;
  std::vector<std::uint8_t> quiet_;  // by symbol
  std::vector<Branch> branches_;
  std::size_t next_branch_ = 0;  // that the walk has not come to
};

}  // namespace panicle::lsystem
