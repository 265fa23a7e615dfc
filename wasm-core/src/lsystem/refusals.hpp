// Why productions do not rewrite a module, in words.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lsystem/machine.hpp"

namespace panicle::lsystem {

// A production that does not rewrite a module, and why: "its condition is false with x = 3".
struct Refusal {
  Place production;
  std::string why;
};

// Of a string and the step that rewrites it next; whatever is looked up is what that step looks up, draws included.
class Refusals {
 public:
  static constexpr std::size_t most = 24;                   // of one module; further productions are left out
  static constexpr std::uint64_t most_looked = 20'000'000;  // modules; brackets beyond are not looked for

  // Modules draw for `step` where it is given, else once for all steps. `answered`: whether ?E has been answered since
  // the step before. All must outlive it.
  Refusals(const Bound& bound, std::uint64_t seed, const Limits& limits, const Space* space, const String& string,
           std::optional<std::uint32_t> step, bool answered);

  // Of the module at a word of the string, in the order of the text: every production of its symbol but the one that
  // rewrites it. Modules have to be looked up in the order of the string. Nothing once the limits are used up.
  std::vector<Refusal> of(std::uint64_t at);

 private:
  bool looks_on() { return ++looked_ < most_looked; }
  std::string why(const Production& production, Machine::Obstacle obstacle, const std::uint32_t* module);
  std::string why_not_beside(const Production& production, const std::uint32_t* module);
  std::string values_of(const Production& production) const;
  bool heads_a_branch(const std::uint32_t* module, std::uint32_t symbol);
  bool ends_a_branch(std::uint64_t at, std::uint32_t symbol);
  bool is_seen(std::uint32_t symbol) const;

  const Program& program_;
  Machine machine_;
  Neighbourhood neighbourhood_;
  const String& string_;
  bool answered_;
  bool sees_ = false;         // whether neighbours are known
  std::uint64_t looked_ = 0;  // modules, for brackets between neighbours
};

}  // namespace panicle::lsystem
