// The numbers of a growth grammar worked out: words in, a finite number out.
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

  // What D(0), D(1) … and E(0), E(1) … are.
  void give(std::vector<float> branches, std::vector<float> leaves);
  void set(Word word, float value) { registers_[static_cast<std::size_t>(word)] = value; }
  float get(Word word) const { return registers_[static_cast<std::size_t>(word)]; }
  // For whom random values are drawn from now on.
  void at(std::uint64_t address) { sources_.address = address; }

  // Whether a condition holds; where there is none it does. False with `failed()` where it goes wrong.
  bool holds(const Number& condition);
  // A finite number. False: `trouble()`.
  bool work_out(const Number& number, float& value);
  // The same, from `least` to `most`: `what` has to be that.
  bool within(const Number& number, float least, float most, const char* what, float& value);
  bool whole(const Number& number, float least, float most, const char* what, std::uint32_t& value);
  // From 0 to 1; 1 where it is not given.
  bool probability(const Number& number, float& value);

  // What all that was worked out has taken so far, in units of work.
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
