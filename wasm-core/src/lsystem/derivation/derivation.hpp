// A derivation whose string can be read, and whose queries can be responded to, between steps.
//
// Open L-systems (Měch and Prusinkiewicz 1996, section 3): a step rewrites the string, then the environment responds to
// the communication modules in it, and the next step rewrites these by the responses:
//
//   Derivation derivation(bound, seed, limits);
//   while (derivation.steps() < n && derivation.query_environment(start, environment)) derivation.step();
//   if (derivation.error().reason != Reason::none) …
//   interpret_without_queries(bound, derivation.string(), start, drawing, limits);
#pragma once

#include <cstdint>
#include <vector>

#include "lsystem/derivation/machine.hpp"
#include "lsystem/derivation/neighbourhood.hpp"
#include "lsystem/derivation/watcher.hpp"
#include "lsystem/derivation/words.hpp"
#include "lsystem/lsystem.hpp"

namespace panicle::lsystem {

class Derivation {
 public:
  // When the random values that decide whether a module is rewritten are drawn.
  enum class Chance : std::uint8_t { each_step, once };

  // Begins with the axiom. The references must outlive the derivation.
  Derivation(const BoundProgram& bound, std::uint64_t seed, const Limits& limits, Chance chance = Chance::each_step,
             const DerivationOptions& options = {});

  // Rewrites all modules once, those of ?E only where they have had a response since the last step. Returns whether
  // anything was rewritten; false also on an error. A step in which nothing was rewritten counts as well: a random
  // condition is drawn anew in the next.
  bool step();

  // Interprets the string as `interpret` does, but writes each response into the parameters of its ?E and draws nothing
  // in its place. False on an error.
  bool query_environment(const Turtle& start, Listener& listener);

  // The present string; changed by the next step.
  const String& string() const { return now_.string; }
  String take_string() && { return std::move(now_.string); }
  std::uint32_t steps() const { return steps_; }
  // Whether no step would rewrite anything any more, except for responses to ?E.
  bool at_rest() const { return at_rest_; }
  // The first error: evaluation, with line and column; limit. Reason::none without an error. An error ends the
  // derivation.
  const Diagnostic& error() const { return machine_.error(); }

 private:
  // A string and the places of its active modules.
  struct Draft {
    String string;
    Words active;
    std::uint64_t active_count = 0;
  };

  bool begin();
  bool rewrite();
  bool rewrite_module(std::uint64_t at);
  bool look_around(std::uint64_t at);
  bool out_of_sight();
  bool stays_active(std::uint32_t header) const;
  bool keep_active(std::uint64_t at);
  bool cut(std::uint64_t at);
  bool copy_up_to(std::uint64_t at);
  void make_ready();
  bool make_room(std::uint64_t run, const Template& successor);
  bool append(const Template& successor, const Origin& origin, std::uint32_t symbol, const Production* by);
  bool append_watched(std::uint64_t at, const Production& by, const Origin& origin, std::uint32_t symbol);
  bool append_parts(const Template& successor, const Origin& origin, std::uint32_t symbol, const Production* by,
                    std::uint32_t depth);
  bool append_module(const std::uint32_t* module);
  bool locate();

  const BoundProgram& bound_;
  const Program& program_;
  Limits limits_;
  Chance chance_;
  std::uint64_t seed_;
  DerivationOptions options_;
  Machine machine_;
  Neighbourhood neighbourhood_;
  const Rules* parts_ = nullptr;   // decomposition rules, by symbol
  std::vector<Words> part_words_;  // by depth
  Draft now_;
  Draft next_;
  std::uint64_t walked_ = 0;  // words on the way to modules in context, not yet spent
  std::uint64_t copied_ = 0;  // words of `now_` that this step is done with
  std::uint32_t steps_ = 0;
  bool rewrote_ = false;   // in this step
  bool waiting_ = false;   // whether a module may be rewritten in a later step by chance
  bool answered_ = false;  // since the last step
  bool at_rest_ = false;
};

// The string after steps until nothing is rewritten any more: the result of `unfold` for productions in context. A
// random condition draws the same in every step. Errors as there.
Result<Derived> develop_to_rest(const BoundProgram& bound, std::uint64_t seed, const Limits& limits,
                                const DerivationOptions& options = {});

}  // namespace panicle::lsystem
