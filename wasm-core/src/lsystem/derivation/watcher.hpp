// The interface of tools that watch a derivation. Watching changes no result; without a watcher it costs one test for
// each module that is rewritten.
#pragma once

#include <cstdint>

#include "lsystem/derivation/program.hpp"
#include "lsystem/derivation/words.hpp"

namespace panicle::lsystem {

// The order of calls in each step follows its string: `rewrites`, `applied`, `rewritten` for a module that a production
// rewrites, `removes` for a % and its branch; then `ends`. All other modules are copied. A step that fails has no
// `ends`, and is the last.
class Watcher {
 public:
  virtual ~Watcher() = default;

  // The axiom is written, or a step is over; `string` is valid, and changes only by responses, until the next call.
  virtual void begins(const String& string) = 0;
  virtual void ends(const String& string) = 0;

  // The module at a word of the string is rewritten, or drawn by the response in its place.
  virtual void rewrites(std::uint64_t at) = 0;
  // The production is applied and its successor written; `machine` still has the values it was applied with.
  virtual void applied(const Production& production, const class Machine& machine) = 0;
  // Where modules are decomposed: the production that wrote the next module of the string; null for the axiom.
  virtual void part(const Production* production) = 0;
  // The number of modules that were written.
  virtual void rewritten(std::uint64_t modules) = 0;
  // The % at a word of the string is removed with the rest of its branch.
  virtual void removes(std::uint64_t at, std::uint64_t modules) = 0;

  // The environment is queried with the string, and has responded.
  virtual void queries() = 0;
  virtual void responded() = 0;
};

}  // namespace panicle::lsystem
