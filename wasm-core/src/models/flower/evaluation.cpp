#include "models/flower/evaluation.hpp"

#include <algorithm>
#include <cmath>

#include "expression/number_text.hpp"
#include "foundation/random.hpp"
#include "generalized_map/prism.hpp"
#include "models/flower/messages.generated.hpp"

namespace panicle::flower {
namespace {

using expression::error_at;
using expression::number_text;

constexpr float largest = 1e6f;
constexpr std::uint32_t otherwise_steps = 10;  // steps of a grammar that does not set its number

}  // namespace

FlowerEvaluation::FlowerEvaluation(const Program& program, const Given& given)
    : program_(program), given_(given), registers_(program.code.registers) {
  sources_.seed = given.seed;
  set(Word::age, given.age);
}

// Evaluates the variables and the number of steps of all grammars. Returns false with the error in `error()`.
bool FlowerEvaluation::bind(const Limits& limits) {
  max_steps_ = limits.steps;
  for (const Given::Value& value : given_.values) {
    if (!std::isfinite(value.value))
      return fail(error_at(Reason::bad_input, {},
                           message(messages::flower::value_not_finite, value.name, number_text(value.value))));
  }
  variables_.assign(program_.variables.size(), 0);
  for (std::uint32_t i = 0; i < program_.grammars.size(); ++i)
    if (!variables(i, hash_text(program_.grammars[i].name), {})) return false;
  for (const Grammar& grammar : program_.grammars) {
    std::uint32_t& steps = steps_.emplace_back(otherwise_steps);
    if (&grammar == &program_.grammars[0] && given_.steps > 0) {
      steps = given_.steps;
      if (steps > limits.steps)
        return fail(error_at(Reason::limit, {}, message(messages::flower::request_over_limit, steps, limits.steps)));
    } else if (!count(grammar.final_step, steps)) {
      return false;
    }
  }
  return true;
}

// Evaluates a number of steps, which must be whole and at most `max_steps_`; leaves `steps` as it is if the text gives
// none. Returns false with the error in `error()`.
bool FlowerEvaluation::count(const Number& number, std::uint32_t& steps) {
  if (!number.value.given) return true;
  if (!run(number.value.code, hash_text("finalStep"))) return false;
  const float value = at(number.value.source);
  if (!(value >= 0 && std::floor(value) == value))
    return fail(error_at(Reason::evaluation, number.value.place,
                         message(messages::flower::final_step_not_whole, number_text(value))));
  if (value > static_cast<float>(max_steps_))
    return fail(error_at(Reason::limit, number.value.place,
                         message(messages::flower::final_step_over_limit, number_text(value), max_steps_)));
  steps = static_cast<std::uint32_t>(value);
  return true;
}

// Evaluates all variables of a grammar, each after those that it uses, and the code that depends on variables alone.
// `given` are values from a call; `address` is that of random values.
bool FlowerEvaluation::variables(std::uint32_t grammar, std::uint64_t address, const GivenVariables& given) {
  const Grammar& entered = program_.grammars[grammar];
  std::uint32_t followed = entered.once_bound.begin;
  auto next_given = given.begin();
  for (std::uint32_t i = entered.variables.begin; i < entered.variables.end; ++i) {
    execute_once_bound(followed, program_.variables[i].needs);
    followed = program_.variables[i].needs;
    if (next_given != given.end() && next_given->first == i) {
      registers_[program_.variables[i].to] = next_given++->second;
    } else if (!bind_variable(i, address)) {
      return false;
    }
  }
  execute_once_bound(followed, entered.once_bound.end);
  return true;
}

// Evaluates a variable, or takes its value from the request.
bool FlowerEvaluation::bind_variable(std::size_t index, std::uint64_t random_address) {
  const Variable& variable = program_.variables[index];
  float value = 0;
  const auto& expression = variable.number.value;
  const auto given = variable.grammar != 0
                         ? given_.values.end()
                         : std::find_if(given_.values.begin(), given_.values.end(),
                                        [&](const Given::Value& each) { return each.name == variable.name; });
  if (given != given_.values.end()) {
    // Counted as if the code had run: work depends on the text alone, not on given values.
    work_ += expression.code.size();
    value = given->value;
  } else {
    if (!run(expression.code, random_address)) return false;
    value = at(expression.source);
    if (!is_finite(static_cast<std::uint32_t>(index), value, expression.place)) return false;
  }
  registers_[variable.to] = value;
  variables_[index] = value;
  return true;
}

// Whether a variable's value is finite; if not, sets the error.
bool FlowerEvaluation::is_finite(std::uint32_t variable, float value, const expression::SourceLocation& place) {
  if (std::isfinite(value)) return true;
  return fail(
      error_at(Reason::evaluation, place,
               message(messages::flower::result_not_finite, program_.variables[variable].name, number_text(value))));
}

// Executes code that depends on variables alone; errors count where the values are used.
void FlowerEvaluation::execute_once_bound(std::uint32_t begin, std::uint32_t end) {
  work_ += end - begin;
  Diagnostic ignored;
  for (std::uint32_t at = begin; at < end; ++at)
    expression::execute(program_.code, at, at + 1, registers_.data(), sources_, ignored);
}

// Makes an instance of a grammar the current one: binds its variables with the values that its call gives, and its
// number of steps.
bool FlowerEvaluation::enter(std::uint32_t grammar, std::uint64_t address, const GivenVariables& given) {
  const auto ends_at = [&](std::uint32_t steps) {
    own_steps_ = steps;
    set(Word::final_step, static_cast<float>(steps));
    return true;
  };
  const Grammar& entered = program_.grammars[grammar];
  if (!entered.draws || grammar == 0) return ends_at(steps_[grammar]);
  work_ += entered.variables.size();
  if (!variables(grammar, address, given)) return false;
  // With the values that this instance was given and has drawn.
  std::uint32_t steps = steps_[grammar];
  return count(entered.final_step, steps) && ends_at(steps);
}

// Evaluates the values that a call gives to a module's variables, sorted by variable.
bool FlowerEvaluation::evaluate_settings(const std::vector<Setting>& settings, std::uint64_t address,
                                         GivenVariables& given) {
  given.clear();
  for (const Setting& setting : settings) {
    ++work_;
    if (!run(setting.value.code, address)) return false;
    const float value = at(setting.value.source);
    if (!is_finite(setting.variable, value, setting.value.place)) return false;
    given.emplace_back(setting.variable, value);
  }
  // In the order of the text, since later variables use earlier ones.
  std::sort(given.begin(), given.end());
  return true;
}

// Sets the words that expressions can use: a volume's values, its rank in its organ, and the step.
void FlowerEvaluation::set_volume(const VolumeValues& values, const Rank& rank, std::uint32_t step) {
  std::copy(values.begin(), values.end(), registers_.begin());
  set(Word::step, static_cast<float>(step));
  set(Word::along, rank.along);
  set(Word::beside, rank.beside);
}

// Whether a condition holds; true where none is given. Also false if the evaluation fails: see `failed()`.
bool FlowerEvaluation::holds(const Number& condition, std::uint64_t address) {
  if (!condition.value.given) return true;
  return run(condition.value.code, address) && at(condition.value.source) != 0;
}

// Executes code with random values of an address. Returns false with the error in `error()`.
bool FlowerEvaluation::run(expression::Range code, std::uint64_t address) {
  work_ += code.size();
  sources_.address = address;
  return expression::execute(program_.code, code.begin, code.end, registers_.data(), sources_, error_);
}

// Evaluates the numbers of a description and overwrites those values that it gives; each must be in range.
bool FlowerEvaluation::describe(const Description& description, std::uint64_t address, VolumeValues& values) {
  if (description.given == 0) return true;
  if (!run(description.code, address)) return false;
  for (std::size_t i = 0; i < fields; ++i) {
    if ((description.given >> i & 1) == 0) continue;
    const float value = at(description.sources[i]);
    if (!(value >= -largest && value <= largest))
      return fail(error_at(
          Reason::evaluation, description.places[i],
          message(std::isinf(value) ? messages::flower::number_infinite : messages::flower::number_out_of_range,
                  field_names[i], number_text(value), number_text(registers_[static_cast<std::size_t>(Word::step)]))));
    if (i == 0 && !(std::floor(value) == value && value >= generalized_map::least_order &&
                    value <= generalized_map::largest_order))
      return fail(error_at(Reason::evaluation, description.places[i],
                           message(messages::flower::sides_out_of_range, number_text(value))));
    values[i] = value;
  }
  return true;
}

}  // namespace panicle::flower
