// Derivation between two buffers. A list of the modules that may still be rewritten leads through the string; what lies
// between two of them is copied in runs. A module that no production matches never will be: productions see nothing but
// a module's own parameters and its address, and neither changes. It leaves the list.

#include <algorithm>
#include <string>
#include <utility>

#include "foundation/random.hpp"
#include "lsystem/machine.hpp"

namespace panicle::lsystem {
namespace {

// A string and the places of its active modules.
struct Draft {
  Words words;
  Words active;
  std::uint64_t used = 0;
  std::uint64_t active_count = 0;
  std::uint64_t modules = 0;
};

class Derivation {
 public:
  Derivation(const Bound& bound, std::uint64_t seed, const Limits& limits)
      : machine_(bound, seed, limits), program_(*bound.program), limits_(limits) {}

  Result<Derived> run(std::uint32_t max_steps) {
    if (!axiom()) return machine_.trouble();
    Derived derived;
    while (now_.active_count > 0) {
      const bool at_limit = derived.steps >= limits_.steps;
      if (derived.steps >= max_steps && !at_limit) break;
      if (!step()) return machine_.trouble();
      if (!rewrote_) break;
      if (at_limit) return machine_.too_many_steps();
      std::swap(now_, next_);
      ++derived.steps;
      derived.modules_written += now_.modules;
    }
    derived.string = std::make_shared<const String>(std::move(now_.words), now_.used, now_.modules);
    return derived;
  }

 private:
  bool axiom() {
    const Template& axiom = program_.axiom;
    const std::uint64_t root = hash_text("axiom");
    machine_.begin(root);
    if (!make_room(0, axiom)) return false;
    next_.modules = 0;
    if (!append(axiom, {root, no_symbol << 16 | no_symbol}, no_symbol)) return false;
    std::swap(now_, next_);
    return true;
  }

  // One step from `now_` to `next_`; `rewrote_` says whether there was anything to do.
  bool step() {
    rewrote_ = false;
    next_.used = next_.active_count = 0;
    next_.modules = now_.modules;
    make_ready();
    const std::uint32_t* const string = now_.words.data();
    const std::uint32_t* const active = now_.active.data();
    std::uint64_t copied = 0;  // words of `now_` that are done with
    for (std::uint64_t i = 0; i < now_.active_count; ++i) {
      const std::uint64_t at = active[i];
      if (at < copied) continue;  // cut
      const std::uint32_t* const module = string + at;
      if (symbol_of(*module) == cut_symbol) {
        if (!make_room(at - copied, {})) return false;
        copy_run(string + copied, at - copied);
        copied = cut(at);
        rewrote_ = true;
        continue;
      }
      const Production* const production = machine_.choose(module);
      if (production == nullptr) {
        if (machine_.failed()) return false;
        continue;
      }
      if (!make_room(at - copied, production->successor)) return false;
      copy_run(string + copied, at - copied);
      copied = at + words_of(*module);
      --next_.modules;
      const Origin origin = has_lineage(*module) ? origin_of(module) : Origin{};
      if (!append(production->successor, origin, symbol_of(*module))) return false;
      rewrote_ = true;
    }
    if (!rewrote_) return true;
    if (!make_room(now_.used - copied, {})) return false;
    copy_run(string + copied, now_.used - copied);
    return machine_.spend(next_.used / 32);
  }

  // Room for what the step is likely to write, taken while there is nothing to move: a growing string about doubles.
  void make_ready() {
    const std::uint64_t most = now_.used + now_.active_count * program_.longest_successor;
    const std::uint64_t likely = std::min(most, 2 * now_.used + program_.longest_successor);
    next_.words.empty_for(std::min<std::uint64_t>(likely, limits_.words));
  }

  void copy_run(const std::uint32_t* from, std::uint64_t count) {
    copy_words(next_.words.data() + next_.used, from, static_cast<std::size_t>(count));
    next_.used += count;
  }

  bool append(const Template& successor, const Origin& origin, std::uint32_t symbol) {
    if (!machine_.write(successor, next_.words.data() + next_.used, origin, symbol)) return false;
    std::uint32_t* const list = next_.active.data() + next_.active_count;
    const std::uint32_t* const offsets = program_.active.data() + successor.active.begin;
    const std::uint32_t count = successor.active.size();
    for (std::uint32_t i = 0; i < count; ++i) list[i] = static_cast<std::uint32_t>(next_.used) + offsets[i];
    next_.active_count += count;
    next_.used += successor.words;
    next_.modules += successor.modules;
    return true;
  }

  // Room in `next_` for a run and a successor.
  bool make_room(std::uint64_t run, const Template& successor) {
    const std::uint64_t words = next_.used + run + successor.words;
    const std::uint64_t active = next_.active_count + successor.active.size();
    return machine_.make_room(next_.words, words) && machine_.make_room(next_.active, active);
  }

  // Passes over the % at `at` and what it removes: up to the bracket that closes its branch, or to the end.
  std::uint64_t cut(std::uint64_t at) {
    const std::uint32_t* const string = now_.words.data();
    for (std::uint64_t open = 0; at < now_.used; at += words_of(string[at])) {
      const std::uint32_t symbol = symbol_of(string[at]);
      if (symbol == push_symbol) ++open;
      if (symbol == pop_symbol && open-- == 0) break;
      --next_.modules;
    }
    return at;
  }

  Machine machine_;
  const Program& program_;
  const Limits& limits_;
  Draft now_;
  Draft next_;
  bool rewrote_ = false;
};

}  // namespace

Result<Derived> derive(const Bound& bound, std::uint64_t seed, std::uint32_t max_steps, const Limits& limits) {
  return Derivation(bound, seed, limits).run(max_steps);
}

std::uint64_t length(const String& string) { return string.modules(); }

}  // namespace panicle::lsystem
