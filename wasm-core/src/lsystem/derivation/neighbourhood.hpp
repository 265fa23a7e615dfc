// The context of a module in a string: on the left the path from the root to it, on the right the axial tree behind it
// (Prusinkiewicz & Lindenmayer 1990, sections 1.8 and 1.10.3).
#pragma once

#include <cstdint>
#include <vector>

#include "lsystem/derivation/program.hpp"
#include "lsystem/derivation/words.hpp"

namespace panicle::lsystem {

// One walk over a string finds the adjacent modules of each context-sensitive module (one whose symbol has a production
// in context); `go_to` then moves from one of these to the next.
class Neighbourhood {
 public:
  // `program` must outlive it.
  explicit Neighbourhood(const Program& program);

  // Indexes a string, which must not change until the next call, and begins before its first module. False: no memory.
  bool begin(const String& string);

  // Moves on to the context-sensitive module at a word of the string, no earlier than the current one. `looked` grows
  // by the words on the way.
  void go_to(std::uint64_t at, std::uint64_t& looked);

  // Symbol and number of parameters (`Neighbour::kind`) of the modules right before and behind; `Neighbour::any` where
  // there is none.
  std::uint32_t left() const { return left_; }
  std::uint32_t right() const { return right_; }

  // Whether the adjacent modules match those that a production requires: a quick test that rejects most productions.
  bool may_fit(const Production& production) const {
    return (production.nearest_left == Neighbour::any || production.nearest_left == left_) &&
           (production.nearest_right == Neighbour::any || production.nearest_right == right_);
  }

  // Destinations of parameters: `precise`, where it is not null, gets doubles instead.
  struct Registers {
    float* single;
    double* precise;
  };

  // Whether the whole context of a production matches. The neighbours' parameters are then in the registers behind the
  // module's own. `looked` grows by the words that were examined.
  bool fits(const Production& production, Registers registers, std::uint64_t& looked);

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  // The actions of the walk at a symbol.
  enum SymbolClass : std::uint32_t { passed_over = 0, seen = 1, context_sensitive = 2, opens = 4, closes = 8 };
  // For each context-sensitive module: its word, and those of the visible modules right before and behind it, or
  // `none`.
  static constexpr std::uint32_t place_words = 3;
  // For each open bracket: its word, the last visible module, and the entry whose right neighbour is pending.
  static constexpr std::uint32_t walk_words = 3;

  bool walk();
  // The kind of module at a place of the string; any if there is none.
  std::uint32_t kind_at(std::uint32_t place) const {
    return place == none ? Neighbour::any : Neighbour::kind(string_->begin()[place]);
  }
  // The end of the branch that begins at a module.
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
  bool has_hidden_context_ = false;    // whether contexts ignore a context-sensitive symbol
  bool wants_ends_ = false;            // whether branches are passed over or looked into
  const String* string_ = nullptr;
  Words places_, open_;
  Words before_;  // at the word of a visible module: the visible module before it; filled only for contexts of several
                  // modules
  Words ends_;    // of branches, at the words of their brackets
  std::uint64_t next_ = 0;  // word of the places
  std::uint64_t at_ = 0;    // word of the module, and of the adjacent ones
  std::uint32_t before_it_ = none, behind_it_ = none;
  std::uint32_t left_ = Neighbour::any, right_ = Neighbour::any;  // their kinds
};

}  // namespace panicle::lsystem
