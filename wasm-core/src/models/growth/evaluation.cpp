#include "models/growth/evaluation.hpp"

#include <cmath>
#include <string>

#include "expression/number_text.hpp"

namespace panicle::growth {

using expression::error_at;
using expression::number_text;

GrowthEvaluation::GrowthEvaluation(const Rules& rules, std::uint64_t seed)
    : code_(rules.code), registers_(rules.code.registers) {
  sources_.arrays = functions_;
  sources_.seed = seed;
  set(Word::one, 1);
}

void GrowthEvaluation::give(std::vector<float> branches, std::vector<float> leaves) {
  functions_ = {std::move(branches), std::move(leaves)};
}

bool GrowthEvaluation::holds(const Number& condition) {
  float truth = 1;
  return !condition.value.given || (work_out(condition, truth) && truth != 0);
}

bool GrowthEvaluation::work_out(const Number& number, float& value) {
  const expression::Value& of = number.value;
  Diagnostic fault;
  work_ += of.code.size() / 8;
  if (!expression::execute(code_, of.code.begin, of.code.end, registers_.data(), sources_, fault)) {
    const bool of_function = fault.message.rfind("There is no ", 0) == 0 && fault.message[13] == '[';
    if (of_function)
      fault.message = expression::sentence("D and E take whole numbers from 0 to % here.",
                                           {std::to_string(std::max<std::size_t>(functions_[0].size(), 1) - 1)});
    return fail(std::move(fault));
  }
  value = registers_[of.source];
  if (std::isfinite(value)) return true;
  return fail(error_at(Reason::evaluation, of.place, "A finite number is needed here, not %.", {number_text(value)}));
}

bool GrowthEvaluation::within(const Number& number, float least, float most, const char* name, float& value) {
  if (!work_out(number, value)) return false;
  if (value >= least && value <= most) return true;
  return fail(error_at(Reason::evaluation, number.value.place, "% is from % to %, not %.",
                       {name, number_text(least), number_text(most), number_text(value)}));
}

bool GrowthEvaluation::whole(const Number& number, float least, float most, const char* name, std::uint32_t& value) {
  float found = 0;
  if (!within(number, least, most, name, found)) return false;
  value = static_cast<std::uint32_t>(found);
  if (static_cast<float>(value) == found) return true;
  return fail(
      error_at(Reason::evaluation, number.value.place, "% is a whole number, not %.", {name, number_text(found)}));
}

bool GrowthEvaluation::probability(const Number& number, float& value) {
  value = 1;
  return !number.value.given || within(number, 0, 1, "A probability", value);
}

}  // namespace panicle::growth
