// Evaluates the numbers of a growth grammar: from words to finite numbers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "foundation/message.hpp"
#include "models/growth/rules.hpp"

namespace panicle::growth {

// A number as messages write it: a word of the grammar, or a term.
class Quantity {
 public:
  // A quantity for error messages: a word of the text, or a term.
  constexpr Quantity(const char* word) : word_(word) {}
  constexpr Quantity(const MessageCode<0>& term) : term_(term) {}
  Message in_words() const;

 private:
  const char* word_ = nullptr;  // null for a term
  MessageCode<0> term_{};
};

class GrowthEvaluation {
 public:
  GrowthEvaluation(const Rules& rules, std::uint64_t seed);
  GrowthEvaluation(const GrowthEvaluation&) = delete;

  // Sets the values D(0), D(1) … and E(0), E(1) ….
  void give(std::vector<float> branches, std::vector<float> leaves);
  void set(Word word, float value) { registers_[static_cast<std::size_t>(word)] = value; }
  float get(Word word) const { return registers_[static_cast<std::size_t>(word)]; }
  // Sets the address that random values are drawn for from now on.
  void at(std::uint64_t address) { sources_.address = address; }

  // Whether a condition holds; true without a condition. False with `failed()` where evaluation fails.
  bool holds(const Number& condition);
  // Evaluates to a finite number. False: `error()`.
  bool work_out(const Number& number, float& value);
  // Evaluates to a number from `least` to `most`; `quantity` is the number in messages.
  bool within(const Number& number, float least, float most, const Quantity& quantity, float& value);
  bool whole(const Number& number, float least, float most, const Quantity& quantity, std::uint32_t& value);
  // Evaluates to a number from 0 to 1; 1 where none is given.
  bool probability(const Number& number, float& value);

  // Work of all evaluations so far, in units of work.
  std::uint64_t work() const { return work_; }

  // Stores an error; returns false.
  bool fail(Diagnostic error) {
    error_ = std::move(error);
    return false;
  }
  bool failed() const { return error_.reason != Reason::none; }
  const Diagnostic& error() const { return error_; }

 private:
  const expression::Code& code_;
  std::vector<float> registers_;
  std::array<std::vector<float>, 2> functions_;
  expression::Sources sources_;
  std::uint64_t work_ = 0;
  Diagnostic error_;
};

}  // namespace panicle::growth
