// The reasons, as text, for which productions do not rewrite a module.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lsystem/derivation/machine.hpp"

namespace panicle::lsystem {

// A production that does not rewrite a module, and the reason: "the condition is false with x = 3".
struct Refusal {
  SourceLocation production;
  std::string reason;
};

// Finds the reasons for modules of one string. Conditions, contexts and random draws are evaluated as the step that
// rewrites the string next evaluates them.
class Refusals {
 public:
  static constexpr std::size_t most = 24;  // reasons of one module; further productions are left out
  // Modules that all searches for brackets between neighbours may visit; then brackets are no longer reported.
  static constexpr std::uint64_t max_visited = 20'000'000;

  // Random draws are those of `step`; without one, each module draws once for all steps. `answered`: whether ?E has had
  // responses since the step before. The references must outlive this object.
  Refusals(const BoundProgram& bound, std::uint64_t seed, const Limits& limits, const Space* space,
           const String& string, std::optional<std::uint32_t> step, bool answered);

  // The reasons for the module that begins at word `at` of the string: one for every production of its symbol but the
  // one that rewrites it, in the order of the text. Call it for modules in the order of the string. Empty once the work
  // budget is used up.
  std::vector<Refusal> of(std::uint64_t at);

 private:
  // Counts a visited module; false at the limit.
  bool may_visit() { return ++visited_ < max_visited; }
  std::string reason_for(const Production& production, Machine::Obstacle obstacle, const std::uint32_t* module);
  std::string context_mismatch(const Production& production, const std::uint32_t* module);
  std::string values_of(const Production& production) const;
  bool begins_branch(const std::uint32_t* module, std::uint32_t symbol);
  bool ends_branch(std::uint64_t at, std::uint32_t symbol);
  bool is_visible(std::uint32_t symbol) const;

  const Program& program_;
  Machine machine_;
  Neighbourhood neighbourhood_;
  const String& string_;
  bool answered_;
  bool has_neighbours_ = false;  // whether `neighbourhood_` describes the string
  std::uint64_t visited_ = 0;    // modules, in searches for brackets
};

}  // namespace panicle::lsystem
