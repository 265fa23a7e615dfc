// Who watches a derivation, for tools that tell of it. Nothing changes by being watched, and where nobody does, it
// costs one look for each module that is rewritten.
#pragma once

#include <cstdint>

#include "lsystem/derivation/program.hpp"
#include "lsystem/derivation/words.hpp"

namespace panicle::lsystem {

// Of each step, in the order of its string: `rewrites`, `applied`, `rewritten` for a module that a production rewrites,
// `removes` for what a % takes; then `ends`. What neither tells of is copied. A step that goes wrong has no end, nor
// has anything else behind it.
class Watcher {
 public:
  virtual ~Watcher() = default;

  // The axiom is there, or the step is over; `string` is good, and stays as it is but for answers, until the next.
  virtual void begins(const String& string) = 0;
  virtual void ends(const String& string) = 0;

  // The module at a word of the string is rewritten, or drawn as what answers it.
  virtual void rewrites(std::uint64_t at) = 0;
  // By this production, whose successor has been written; `machine` still has what it was used with.
  virtual void applied(const Production& production, const class Machine& machine) = 0;
  // Where modules are decomposed: who wrote the next module that comes into the string; null: nobody, it is the
  // axiom's.
  virtual void part(const Production* production) = 0;
  // Into so many modules.
  virtual void rewritten(std::uint64_t modules) = 0;
  // The % at a word of the string and what it takes with it.
  virtual void removes(std::uint64_t at, std::uint64_t modules) = 0;

  // The environment is asked what stands in the string, and has answered.
  virtual void queries() = 0;
  virtual void responded() = 0;
};

}  // namespace panicle::lsystem
