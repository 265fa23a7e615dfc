// What a production sees of the string beside the module that it rewrites: on the left the way from the root to it, on
// the right the axial tree behind it (Prusinkiewicz & Lindenmayer 1990, sections 1.8 and 1.10.3).
#pragma once

#include <cstdint>
#include <vector>

#include "lsystem/derivation/program.hpp"
#include "lsystem/derivation/words.hpp"

namespace panicle::lsystem {

// One walk over a string finds what stands right beside each module that asks, those whose symbol has a production in
// context; then it goes from one of these to the next.
class Neighbourhood {
 public:
  // `program` must outlive it.
  explicit Neighbourhood(const Program& program);

  // Looks at a string, which stays as it is until the next, and begins before its first module. False: no memory.
  bool begin(const String& string);

  // Goes on to the asking module at a word of the string, no earlier than where it stands. `looked` grows by the words
  // on the way.
  void go_to(std::uint64_t at, std::uint64_t& looked);

  // Of what stands right before and behind the module, its symbol and how many parameters (`Neighbour::kind`);
  // `Neighbour::any` where nothing does.
  std::uint32_t left() const { return left_; }
  std::uint32_t right() const { return right_; }

  // Whether what stands right beside the module is what a production wants there: most productions are out by that.
  bool may_fit(const Production& production) const {
    return (production.nearest_left == Neighbour::any || production.nearest_left == left_) &&
           (production.nearest_right == Neighbour::any || production.nearest_right == right_);
  }

  // Where parameters go: to the second, where it is not null, in double precision.
  struct Registers {
    float* single;
    double* precise;
  };

  // Whether the module has beside it what a production in context wants. Their parameters are then in the registers
  // behind the module's own. `looked` grows by the words that were looked at.
  bool fits(const Production& production, Registers registers, std::uint64_t& looked);

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  // What a walk does at a symbol.
  enum SymbolClass : std::uint32_t { passed_over = 0, seen = 1, context_sensitive = 2, opens = 4, closes = 8 };
  // Of each module that asks: its word, and those of what is seen right before and behind it, or `none`.
  static constexpr std::uint32_t place_words = 3;
  // Of each bracket that is open: its word, what was seen last, and who had not been told what is behind it.
  static constexpr std::uint32_t walk_words = 3;

  bool walk();
  std::uint32_t kind_at(std::uint32_t place) const {
    return place == none ? Neighbour::any : Neighbour::kind(string_->begin()[place]);
  }
  const std::uint32_t* end_of_branch(const std::uint32_t* at) const {
    return string_->begin() + ends_.data()[at - string_->begin()];
  }
  bool fits_left(Range wanted, Registers registers) const;
  const std::uint32_t* follow(std::uint32_t begin, std::uint32_t end, const std::uint32_t* at, Registers registers,
                              std::uint64_t& looked) const;
  const std::uint32_t* next_seen(const std::uint32_t* at, bool into_branches, std::uint64_t& looked) const;
  bool is(const Neighbour& wanted, const std::uint32_t* module, Registers registers) const;

  const Program& program_;
  std::vector<std::uint8_t> classes_;  // by symbol
  bool has_hidden_context_ = false;          // whether contexts do not see all that ask
  bool wants_ends_ = false;          // whether branches are passed over or looked into
  const String* string_ = nullptr;
  Words places_, open_;
  Words before_;            // at the word of what is seen: what is seen before it, where anyone wants more than one
  Words ends_;              // of branches, at the words of their brackets
  std::uint64_t next_ = 0;  // word of the places
  std::uint64_t at_ = 0;    // word of the module, and of what is right beside it
  std::uint32_t before_it_ = none, behind_it_ = none;
  std::uint32_t left_ = Neighbour::any, right_ = Neighbour::any;  // their kinds
};

}  // namespace panicle::lsystem
