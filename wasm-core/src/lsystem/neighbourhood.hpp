// What a production sees of the string beside the module that it rewrites: on the left the way from the root to it, on
// the right the axial tree behind it (Prusinkiewicz & Lindenmayer 1990, sections 1.8 and 1.10.3).
#pragma once

#include <cstdint>

#include "lsystem/program.hpp"
#include "lsystem/words.hpp"

namespace panicle::lsystem {

// Goes through one string after the other, from module to module, and keeps the way from the root at hand.
class Neighbourhood {
 public:
  // `program` must outlive it.
  explicit Neighbourhood(const Program& program) : program_(program) {}

  // Begins before the first module of a string, which stays as it is until the next. False: no memory.
  bool begin(const String& string);

  // Goes on to the module at a word of the string, no earlier than where it stands. `looked` grows by the words on the
  // way. False: no memory.
  bool go_to(std::uint64_t at, std::uint64_t& looked);

  // Whether what stands right beside the module is what a production wants there: most productions are out by that.
  bool may_fit(const Production& production) const {
    return (production.nearest_left == no_symbol || production.nearest_left == left_) &&
           (production.nearest_right == no_symbol || production.nearest_right == right_);
  }

  // Whether the module has beside it what a production in context wants. Their parameters are then in the registers
  // behind the module's own. `looked` grows by the words that were looked at.
  bool fits(const Production& production, float* registers, std::uint64_t& looked);

 private:
  bool is_seen(std::uint32_t symbol) const { return program_.passed_over[symbol] == 0; }
  bool find_ends();
  const std::uint32_t* end_of_branch(const std::uint32_t* at) const {
    return string_->begin() + ends_.data()[at - string_->begin()];
  }
  bool fits_left(Range wanted, float* registers) const;
  const std::uint32_t* follow(std::uint32_t begin, std::uint32_t end, const std::uint32_t* at, float* registers,
                              std::uint64_t& looked) const;
  const std::uint32_t* next_seen(const std::uint32_t* at, bool into_branches, std::uint64_t& looked) const;
  bool is(const Neighbour& wanted, const std::uint32_t* module, float* registers) const;

  const Program& program_;
  const String* string_ = nullptr;
  std::uint64_t at_ = 0;
  Words path_;  // places of the modules seen on the way from the root
  std::uint64_t path_length_ = 0;
  Words open_;  // the way's length where each open branch begins
  std::uint64_t open_count_ = 0;
  Words ends_;                                          // of branches, at the words of their brackets
  const std::uint32_t* behind_ = nullptr;               // what is seen behind the module on its axis
  std::uint32_t left_ = no_symbol, right_ = no_symbol;  // what is seen right beside it
};

}  // namespace panicle::lsystem
