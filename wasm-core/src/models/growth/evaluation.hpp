// Evaluates the numbers of a growth grammar: from words to finite numbers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "models/growth/rules.hpp"

namespace panicle::growth {

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
  // Evaluates to a finite number. False: `trouble()`.
  bool work_out(const Number& number, float& value);
  // Evaluates to a number from `least` to `most`; `name` is the number's in messages.
  bool within(const Number& number, float least, float most, const char* name, float& value);
  bool whole(const Number& number, float least, float most, const char* name, std::uint32_t& value);
  // Evaluates to a number from 0 to 1; 1 where none is given.
  bool probability(const Number& number, float& value);

  // Work of all evaluations so far, in units of work.
  std::uint64_t work() const { return work_; }

  bool fail(Diagnostic trouble) {
    trouble_ = std::move(trouble);
    return false;
  }
  bool failed() const { return trouble_.reason != Reason::none; }
  const Diagnostic& trouble() const { return trouble_; }

 private:
  const expression::Code& code_;
  std::vector<float> registers_;
  std::array<std::vector<float>, 2> functions_;
  expression::Sources sources_;
  std::uint64_t work_ = 0;
  Diagnostic trouble_;
};

}  // namespace panicle::growth
