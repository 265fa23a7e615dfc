#include "models/flower/evaluation.hpp"

#include <algorithm>
#include <cmath>

#include "expression/number_text.hpp"
#include "foundation/random.hpp"
#include "generalized_map/prism.hpp"

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

bool FlowerEvaluation::bind(const Limits& limits) {
  most_steps_ = limits.steps;
  for (const Given::Value& value : given_.values) {
    if (!std::isfinite(value.value))
      return fail(error_at(Reason::bad_input, {}, "'%' was given %; give it a finite number.",
                           {value.name, number_text(value.value)}));
  }
  variables_.assign(program_.variables.size(), 0);
  for (std::uint32_t i = 0; i < program_.grammars.size(); ++i)
    if (!variables(i, hash_text(program_.grammars[i].name), {})) return false;
  for (const Grammar& grammar : program_.grammars) {
    std::uint32_t& steps = steps_.emplace_back(otherwise_steps);
    if (&grammar == &program_.grammars[0] && given_.steps > 0) {
      steps = given_.steps;
      if (steps > limits.steps)
        return fail(error_at(Reason::limit, {}, "% steps are asked for; the limit is %.",
                             {std::to_string(steps), std::to_string(limits.steps)}));
    } else if (!count(grammar.final_step, steps)) {
      return false;
    }
  }
  return true;
}

bool FlowerEvaluation::count(const Number& number, std::uint32_t& steps) {
  if (!number.value.given) return true;
  if (!run(number.value.code, hash_text("finalStep"))) return false;
  const float value = at(number.value.source);
  if (!(value >= 0 && std::floor(value) == value))
    return fail(error_at(Reason::evaluation, number.value.place,
                         "finalStep comes to %; it must be a whole number of 0 or more.", {number_text(value)}));
  if (value > static_cast<float>(most_steps_))
    return fail(error_at(Reason::limit, number.value.place, "finalStep comes to %; the limit is %.",
                         {number_text(value), std::to_string(most_steps_)}));
  steps = static_cast<std::uint32_t>(value);
  return true;
}

// Evaluates all variables of a grammar, each after those that it uses, and then the code that depends on variables
// alone.
bool FlowerEvaluation::variables(std::uint32_t grammar, std::uint64_t address, const GivenVariables& given) {
  const Grammar& of = program_.grammars[grammar];
  std::uint32_t followed = of.once_bound.begin;
  auto next_given = given.begin();
  for (std::uint32_t i = of.variables.begin; i < of.variables.end; ++i) {
    follow(followed, program_.variables[i].needs);
    followed = program_.variables[i].needs;
    if (next_given != given.end() && next_given->first == i) {
      registers_[program_.variables[i].to] = next_given++->second;
    } else if (!variable(i, address)) {
      return false;
    }
  }
  follow(followed, of.once_bound.end);
  return true;
}

bool FlowerEvaluation::variable(std::size_t at, std::uint64_t address) {
  const Variable& variable = program_.variables[at];
  float value = 0;
  const expression::Value& of = variable.number.value;
  const auto given = variable.grammar != 0
                         ? given_.values.end()
                         : std::find_if(given_.values.begin(), given_.values.end(),
                                        [&](const Given::Value& each) { return each.name == variable.name; });
  if (given != given_.values.end()) {
    // Equal work for all flowers with the same map.
    work_ += of.code.size();
    value = given->value;
  } else {
    if (!run(of.code, address)) return false;
    value = this->at(of.source);
    if (!is_finite(static_cast<std::uint32_t>(at), value, of.place)) return false;
  }
  registers_[variable.to] = value;
  variables_[at] = value;
  return true;
}

bool FlowerEvaluation::is_finite(std::uint32_t variable, float value, const expression::SourceLocation& place) {
  if (std::isfinite(value)) return true;
  return fail(error_at(Reason::evaluation, place, "'%' comes to %; it must be a finite number.",
                       {program_.variables[variable].name, number_text(value)}));
}

// Executes code that depends on variables alone; errors count where the values are used.
void FlowerEvaluation::follow(std::uint32_t begin, std::uint32_t end) {
  work_ += end - begin;
  Diagnostic ignored;
  for (std::uint32_t at = begin; at < end; ++at)
    expression::execute(program_.code, at, at + 1, registers_.data(), sources_, ignored);
}

bool FlowerEvaluation::enter(std::uint32_t grammar, std::uint64_t address, const GivenVariables& given) {
  const auto ends_at = [&](std::uint32_t steps) {
    own_steps_ = steps;
    set(Word::final_step, static_cast<float>(steps));
    return true;
  };
  const Grammar& of = program_.grammars[grammar];
  if (!of.draws || grammar == 0) return ends_at(steps_[grammar]);
  work_ += of.variables.size();
  if (!variables(grammar, address, given)) return false;
  // With the values that this instance was given and has drawn.
  std::uint32_t steps = steps_[grammar];
  return count(of.final_step, steps) && ends_at(steps);
}

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

void FlowerEvaluation::set_volume(const VolumeValues& values, const Rank& rank, std::uint32_t step) {
  std::copy(values.begin(), values.end(), registers_.begin());
  set(Word::step, static_cast<float>(step));
  set(Word::along, rank.along);
  set(Word::beside, rank.beside);
}

bool FlowerEvaluation::holds(const Number& condition, std::uint64_t address) {
  if (!condition.value.given) return true;
  return run(condition.value.code, address) && at(condition.value.source) != 0;
}

bool FlowerEvaluation::run(expression::Range code, std::uint64_t address) {
  work_ += code.size();
  sources_.address = address;
  return expression::execute(program_.code, code.begin, code.end, registers_.data(), sources_, trouble_);
}

bool FlowerEvaluation::describe(const Description& description, std::uint64_t address, VolumeValues& values) {
  if (description.given == 0) return true;
  if (!run(description.code, address)) return false;
  for (std::size_t i = 0; i < fields; ++i) {
    if ((description.given >> i & 1) == 0) continue;
    const float value = at(description.sources[i]);
    if (!(value >= -largest && value <= largest))
      return fail(
          error_at(Reason::evaluation, description.places[i],
                   "% comes to % in step %%; it must be a number between -1000000 and 1000000.",
                   {field_names[i], number_text(value), number_text(registers_[static_cast<std::size_t>(Word::step)]),
                    std::isinf(value) ? ", as by a division by 0" : ""}));
    if (i == 0 && !(std::floor(value) == value && value >= generalized_map::least_order &&
                    value <= generalized_map::largest_order))
      return fail(error_at(Reason::evaluation, description.places[i],
                           "N comes to %; a prism has a whole number of sides, 3 to 4096.", {number_text(value)}));
    values[i] = value;
  }
  return true;
}

}  // namespace panicle::flower
