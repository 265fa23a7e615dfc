#include "models/growth/evaluation.hpp"

#include <cmath>
#include <string>

#include "expression/messages.generated.hpp"
#include "expression/number_text.hpp"
#include "models/growth/messages.generated.hpp"

namespace panicle::growth {

using expression::error_at;
using expression::number_text;

// The quantity's name for messages: a word of the grammar or a term.
Message Quantity::in_words() const {
  return word_ == nullptr ? message(term_) : message(messages::growth::term_word, word_);
}

GrowthEvaluation::GrowthEvaluation(const Rules& rules, std::uint64_t seed)
    : code_(rules.code), registers_(rules.code.registers) {
  sources_.arrays = functions_;
  sources_.seed = seed;
  set(Word::one, 1);
}

// Sets the values of the divisor functions for branches and leaves, by their arguments from 0 on.
void GrowthEvaluation::give(std::vector<float> branches, std::vector<float> leaves) {
  functions_ = {std::move(branches), std::move(leaves)};
}

// Whether a condition holds; true where none is given. Also false if the evaluation fails: see `failed()`.
bool GrowthEvaluation::holds(const Number& condition) {
  float truth = 1;
  return !condition.value.given || (work_out(condition, truth) && truth != 0);
}

// Evaluates an expression to a finite number. Returns false with the error in `error()`.
bool GrowthEvaluation::work_out(const Number& number, float& value) {
  const expression::Value& of = number.value;
  Diagnostic fault;
  work_ += of.code.size() / 8;
  if (!expression::execute(code_, of.code.begin, of.code.end, registers_.data(), sources_, fault)) {
    if (is_message(fault.message, messages::expression::array_index) ||
        is_message(fault.message, messages::expression::array_empty))
      fault.message = message(messages::growth::function_argument, std::max<std::size_t>(functions_[0].size(), 1) - 1);
    return fail(std::move(fault));
  }
  value = registers_[of.source];
  if (std::isfinite(value)) return true;
  return fail(error_at(Reason::evaluation, of.place, message(messages::growth::not_finite, number_text(value))));
}

// Evaluates a number from `least` to `most`; the error message calls it by `quantity`.
bool GrowthEvaluation::within(const Number& number, float least, float most, const Quantity& quantity, float& value) {
  if (!work_out(number, value)) return false;
  if (value >= least && value <= most) return true;
  return fail(error_at(Reason::evaluation, number.value.place,
                       message(messages::growth::out_of_range, number_text(value), quantity.in_words(),
                               number_text(least), number_text(most))));
}

// Evaluates a whole number from `least` to `most`.
bool GrowthEvaluation::whole(const Number& number, float least, float most, const Quantity& quantity,
                             std::uint32_t& value) {
  float found = 0;
  if (!within(number, least, most, quantity, found)) return false;
  value = static_cast<std::uint32_t>(found);
  if (static_cast<float>(value) == found) return true;
  return fail(error_at(Reason::evaluation, number.value.place,
                       message(messages::growth::not_whole, number_text(found), quantity.in_words())));
}

// Evaluates a probability from 0 to 1; it is 1 where none is given.
bool GrowthEvaluation::probability(const Number& number, float& value) {
  value = 1;
  return !number.value.given || within(number, 0, 1, messages::growth::term_probability, value);
}

}  // namespace panicle::growth
