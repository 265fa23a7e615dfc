#include "lsystem/derivation/machine.hpp"

#include <algorithm>
#include <string>

#include "expression/number_text.hpp"
#include "foundation/random.hpp"
#include "lsystem/messages.generated.hpp"

namespace panicle::lsystem {

// Copies the registers, which evaluation overwrites; `bound` and `limits` must outlive the machine. Work is counted
// against the request's budget, or against one of the machine's own where the request has none.
Machine::Machine(const BoundProgram& bound, std::uint64_t seed, const Limits& limits, const Space* space)
    : program_(*bound.program),
      limits_(limits),
      own_budget_(limits.work, limits.bytes),
      budget_(limits.budget != nullptr ? *limits.budget : own_budget_),
      rules_(program_.rules.data()),
      productions_(program_.productions.data()),
      patches_(program_.patches.data()),
      words_(bound.words.data()),
      register_file_(bound.registers),
      registers_(register_file_.data()),
      precise_file_(bound.precise),
      precise_(program_.code.doubles ? precise_file_.data() : nullptr),
      choice_stream_(hash_text("production")),
      sources_{bound.lists, seed, 0, space, {}} {
  budget_.spend(bound.registers.size() / 32);  // copied for every walk of the turtle
}

// Chooses a production whose conditions or weights are random; null if none matches. In a step these are drawn for the
// module and the step. The choice among several productions, and random values in successors, are drawn for the module
// alone, since that happens only once.
const Production* Machine::choose_by_chance(const Rules& rules, std::uint32_t count) {
  const std::uint64_t address = sources_.address;
  if (stepping_) sources_.address = hash_combine(address, step_);
  const Production* const production =
      rules.weighted ? draw_production(rules, count, address) : first_that_matches(rules, count);
  sources_.address = address;
  return production;
}

// The first reason why a production does not match a module, tested in the order of `matches`: the number of
// parameters, the context, the condition. A random condition is drawn for the same step as in choosing.
Machine::Obstacle Machine::obstacle_of(const Production& production, const std::uint32_t* module) {
  if (production.arity != parameters_of(*module)) return Obstacle::parameters;
  load(module);
  const bool sees_it = !production.in_context || (may_fit(production) && (!production.looks_on || sees(production)));
  if (!sees_it || !spend(production.cost)) return Obstacle::context;
  if (!production.condition.given) return Obstacle::none;
  const std::uint64_t address = sources_.address;
  if (stepping_ && rules_[symbol_of(*module)].by_chance) sources_.address = hash_combine(address, step_);
  const bool met = evaluate(production.condition.code) && holds(production.condition.source);
  sources_.address = address;
  return met ? Obstacle::none : Obstacle::condition;
}

// Whether a module, given by its header word, has a production with a random condition or weight: one that does not
// match now may match in a later step.
bool Machine::waits_for_chance(std::uint32_t header) const {
  const Range range = rules_[symbol_of(header)].productions;
  return std::any_of(productions_ + range.begin, productions_ + range.end, [&](const Production& production) {
    return production.by_chance && production.arity == parameters_of(header);
  });
}

// Chooses by order and weight: if the first production that matches has no weight, it is applied; else one is drawn
// from it and all later ones that match and have a weight.
const Production* Machine::draw_production(const Rules& rules, std::uint32_t count, std::uint64_t address) {
  const Range range = rules.productions;
  if (weights_.size() < range.size()) weights_.resize(range.size());
  if (!spend(range.size() / 16)) return nullptr;
  const Production* tried = nullptr;
  double total = 0;
  for (std::uint32_t i = range.begin; i < range.end; ++i) {
    const Production& production = productions_[i];
    float& weight = weights_[i - range.begin];
    weight = 0;
    if (total > 0 && !production.weight.given) continue;
    tried = &production;
    if (!matches(production, count)) {
      if (failed()) return nullptr;
      continue;
    }
    if (!production.weight.given) return &production;
    if (!weigh(production, weight)) return nullptr;
    total += weight;
  }
  double left = total * random_unit(sources_.seed, choice_stream_, address);
  chance_ = {static_cast<float>(total), 0, static_cast<float>(left)};
  const Production* drawn = nullptr;
  for (std::uint32_t i = range.begin; i < range.end && left >= 0; ++i) {
    const float weight = weights_[i - range.begin];
    if (weight == 0) continue;
    drawn = &productions_[i];
    chance_[1] = weight;
    left -= weight;
  }
  // Reloads the neighbours' parameters, which were overwritten by the production that was tried last.
  if (drawn != nullptr && drawn != tried && drawn->in_context) sees(*drawn);
  return failed() ? nullptr : drawn;
}

// Whether a production's contexts match; loads the neighbours' parameters.
bool Machine::sees(const Production& production) {
  std::uint64_t looked = 0;
  const bool fits = neighbourhood_->fits(production, {registers_, precise_}, looked);
  return spend(looked / 32) && fits;
}

// Computes a production's weight, which must not be negative.
bool Machine::weigh(const Production& production, float& weight) {
  if (!evaluate(production.weight.code)) return false;
  weight = value_of(production.weight.source);
  if (meets(Demand::not_negative, weight)) return true;
  return fail(error_at(Reason::evaluation, production.weight.place,
                       message(messages::lsystem::bad_weight, number_text(weight))));
}

// Writes the lineage of each module of a successor: its address, derived from that of its parent, and the symbols of
// its parent and grandparent.
void Machine::write_lineages(const Template& successor, std::uint32_t* to, const Origin& parent, std::uint32_t symbol) {
  const std::uint32_t ancestors = symbol | (parent.ancestors & 0xffff) << 16;
  for (std::uint32_t i = successor.births.begin; i < successor.births.end; ++i) {
    const Birth& birth = program_.births[i];
    const std::uint64_t address = hash_combine(parent.address, birth.key);
    std::memcpy(to + birth.offset, &address, sizeof address);
    to[birth.offset + 2] = ancestors;
  }
}

// The error of a parameter that the turtle cannot use.
Diagnostic Machine::refusal(const Program& program, const Patch& patch, float value) {
  const MessageCode<2>& code =
      patch.demand == Demand::not_negative ? messages::lsystem::needs_not_negative : messages::lsystem::needs_finite;
  return error_at(Reason::evaluation, patch.place, message(code, program.symbols[patch.symbol], number_text(value)));
}

// Fails with that error.
bool Machine::refuse(const Patch& patch, float value) { return fail(refusal(program_, patch, value)); }

// Fails since time or work is used up.
bool Machine::give_up() {
  if (budget_.time_is_over()) return fail(error_at(Reason::limit, {}, message(messages::lsystem::time_limit)));
  return fail(error_at(Reason::limit, {}, message(messages::lsystem::work_limit, limits_.work)));
}

// Enlarges a string to a number of words, within the limit.
bool Machine::grow(Words& string, std::uint64_t words) {
  if (words > limits_.words)
    return fail(error_at(Reason::limit, {}, message(messages::lsystem::string_limit, limits_.words)));
  if (string.reserve(words, limits_.words)) return true;
  return fail(error_at(Reason::limit, {}, message(messages::lsystem::no_memory_for_string, words)));
}

// The error of a derivation that does not end within the limit of steps.
Diagnostic Machine::too_many_steps(const Limits& limits) {
  return error_at(Reason::limit, {}, message(messages::lsystem::never_ends, limits.steps));
}

}  // namespace panicle::lsystem
