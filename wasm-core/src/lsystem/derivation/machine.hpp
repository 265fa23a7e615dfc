// The common part of derivation and interpretation: chooses a production for a module and writes its successor.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "lsystem/derivation/bound_program.hpp"
#include "lsystem/derivation/neighbourhood.hpp"

namespace panicle::lsystem {

class Machine {
 public:
  Machine(const BoundProgram& bound, std::uint64_t seed, const Limits& limits, const Space* space = nullptr);
  Machine(const Machine&) = delete;

  // Chooses the production that rewrites `module`, and loads the module's parameters; null where none matches, or when
  // `failed()`. A block of words behind the module must be readable.
  const Production* choose(const std::uint32_t* module) { return choose(module, rules_); }
  // The same among the rules `by_symbol` of another purpose.
  const Production* choose(const std::uint32_t* module, const Rules* by_symbol) {
    const Rules& rules = by_symbol[symbol_of(*module)];
    const std::uint32_t count = parameters_of(*module);
    load(module);
    if (rules.by_chance) return choose_by_chance(rules, count);
    return first_that_matches(rules, count);
  }

  // The reason why a production of derivation does not match a module, also where another one comes first. For tools:
  // it costs as much as choosing. Meaningless when `failed()`.
  enum class Obstacle : std::uint8_t { none, parameters, context, condition };
  Obstacle obstacle_of(const Production& production, const std::uint32_t* module);

  // Writes a successor to `to`, where it has room in whole blocks. `parent` is the origin of the module that
  // `choose` looked at last, `symbol` its symbol. False: `error()`.
  bool write(const Template& successor, std::uint32_t* to, const Origin& parent, std::uint32_t symbol) {
    if (!spend(successor.cost) || !evaluate(successor.code)) return false;
    copy_words(to, words_ + successor.first, successor.words);
    for (std::uint32_t i = successor.patches.begin; i < successor.patches.end; ++i) {
      const Patch& patch = patches_[i];
      const float value = value_of(patch.source);
      if (!meets(patch.demand, value)) return refuse(patch, value);
      std::memcpy(to + patch.offset, &value, sizeof value);
      if (precise_ != nullptr) std::memcpy(to + patch.precise, precise_ + patch.source, sizeof *precise_);
    }
    if (successor.births.size() > 0) write_lineages(successor, to, parent, symbol);
    return true;
  }

  // Sets the address for an axiom, which no module writes.
  void begin(std::uint64_t address) { sources_.address = address; }

  // From now on the decision whether a module is rewritten is drawn for this step: a module that was not rewritten is
  // tried anew in the next. Before, one draw holds for all steps.
  void decide_at(std::uint32_t step) {
    step_ = step;
    stepping_ = true;
  }

  // From now on productions in context match by the neighbourhood of the module; before, they match nothing.
  void look_around(Neighbourhood& neighbourhood) { neighbourhood_ = &neighbourhood; }

  // The value of a register: after applying a production, the values that it was applied with.
  float value_of(std::uint32_t source) const {
    return precise_ != nullptr ? static_cast<float>(precise_[source]) : registers_[source];
  }
  // The last random choice by weights: the sum of the weights of all matching productions, the weight of the chosen
  // one, and the random value within the sum.
  const std::array<float, 3>& chance() const { return chance_; }

  // Whether a module that no production matched may be rewritten in a later step, because a condition or weight is
  // random.
  bool tries_again(std::uint32_t header) const {
    return stepping_ && rules_[symbol_of(header)].by_chance && waits_for_chance(header);
  }

  // Takes units of work. False: they are used up.
  bool spend(std::uint64_t units) { return budget_.spend(units) || give_up(); }

  // Reserves `words` of a string and preserves its content. False: beyond Limits::words, or no memory.
  bool make_room(Words& string, std::uint64_t words) {
    return (words <= string.capacity() && words <= limits_.words) || grow(string, words);
  }

  static Diagnostic too_many_steps(const Limits& limits);

  // Stores an error; returns false.
  bool fail(Diagnostic error) {
    error_ = std::move(error);
    return false;
  }
  bool failed() const { return error_.reason != Reason::none; }
  const Diagnostic& error() const { return error_; }

  // Whether a value is as finite, or as positive, as a demand requires. x − x is 0 for finite x only.
  static bool meets(Demand demand, float value) {
    if (demand == Demand::none) return true;
    return value - value == 0 && (demand == Demand::finite || value >= 0);
  }
  static Diagnostic refusal(const Program& program, const Patch& patch, float value);

 private:
  // Loads a module's parameters into the first registers, and the address of its random values. Floats are copied in
  // whole blocks, so the registers and the words behind the module must be readable up to the end of the last one.
  void load(const std::uint32_t* module) {
    const std::uint32_t count = parameters_of(*module);
    if (precise_ != nullptr) {
      std::memcpy(precise_, doubles_of(module), count * sizeof(double));
    } else {
      for (std::uint32_t i = 0; i < count; i += block)
        std::memcpy(registers_ + i, module + 1 + i, block * sizeof(float));
    }
    if (has_lineage(*module)) sources_.address = origin_of(module).address;
  }
  // Whether a production fits the module at hand, which has `count` parameters: their number, its context and its
  // condition. Also false if evaluation fails, see `failed`.
  bool matches(const Production& production, std::uint32_t count) {
    if (production.arity != count || (production.in_context && !may_fit(production))) return false;
    if (!spend(production.cost) || (production.looks_on && !sees(production))) return false;
    if (!production.condition.given) return true;
    return evaluate(production.condition.code) && holds(production.condition.source);
  }
  // Whether the neighbours may fit the production's context: a quick test before the exact one.
  bool may_fit(const Production& production) const {
    return neighbourhood_ != nullptr && neighbourhood_->may_fit(production);
  }
  [[gnu::noinline]] bool sees(const Production& production);
  // Runs a piece of compiled code, in double precision where the module has doubles; false after an error.
  bool evaluate(Range code) {
    if (precise_ != nullptr) return execute(program_.code, code.begin, code.end, precise_, sources_, error_);
    return execute(program_.code, code.begin, code.end, registers_, sources_, error_);
  }
  // Whether the register of a condition is true.
  bool holds(std::uint32_t source) const {
    return precise_ != nullptr ? precise_[source] != 0 : registers_[source] != 0;
  }
  [[gnu::noinline]] const Production* choose_by_chance(const Rules& rules, std::uint32_t count);
  // The first production of a symbol's rules that fits a module of `count` parameters; null if none does, or after an
  // error.
  const Production* first_that_matches(const Rules& rules, std::uint32_t count) {
    for (std::uint32_t i = rules.productions.begin; i < rules.productions.end; ++i) {
      const Production& production = productions_[i];
      if (matches(production, count)) return &production;
      if (failed()) return nullptr;
    }
    spend(rules.productions.size() / 16);  // also those of other numbers of parameters have been looked at
    return nullptr;
  }
  const Production* draw_production(const Rules& rules, std::uint32_t count, std::uint64_t address);
  [[gnu::noinline]] bool waits_for_chance(std::uint32_t header) const;
  bool weigh(const Production& production, float& weight);
  [[gnu::noinline]] void write_lineages(const Template& successor, std::uint32_t* to, const Origin& parent,
                                        std::uint32_t symbol);
  [[gnu::cold]] bool refuse(const Patch& patch, float value);
  [[gnu::cold]] bool give_up();
  [[gnu::noinline]] bool grow(Words& string, std::uint64_t words);

  const Program& program_;
  const Limits& limits_;
  WorkBudget own_budget_;  // where the request has none
  WorkBudget& budget_;
  // Pointers to the program's tables, for the innermost loop.
  const Rules* rules_;
  const Production* productions_;
  const Patch* patches_;
  const std::uint32_t* words_;
  std::vector<float> register_file_;
  float* registers_;
  std::vector<double> precise_file_;
  double* precise_;  // in place of `registers_` where the text calculates in double precision; else null
  std::uint64_t choice_stream_;
  std::vector<float> weights_;  // of the productions that compete
  Neighbourhood* neighbourhood_ = nullptr;
  std::uint32_t step_ = 0;
  bool stepping_ = false;
  Sources sources_;
  std::array<float, 3> chance_ = {};
  Diagnostic error_;
};

}  // namespace panicle::lsystem
