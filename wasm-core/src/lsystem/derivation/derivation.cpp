// Derivation between two buffers. A list of the modules that may still be rewritten (active modules) leads through the
// string; the runs between them are copied. A module that no production matches leaves the list, unless it draws
// randomly, is a query with a response or has productions in context: other productions depend on nothing but a
// module's own parameters and its address.

#include "lsystem/derivation/derivation.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "foundation/random.hpp"
#include "lsystem/derivation/branch.hpp"
#include "lsystem/messages.generated.hpp"
#include "lsystem/turtle/interpretation.hpp"

namespace panicle::lsystem {

Derivation::Derivation(const BoundProgram& bound, std::uint64_t seed, const Limits& limits, Chance chance,
                       const DerivationOptions& options)
    : bound_(bound),
      program_(*bound.program),
      limits_(limits),
      chance_(chance),
      seed_(seed),
      options_(options),
      machine_(bound, seed, limits_, options.space),
      neighbourhood_(program_) {
  machine_.look_around(neighbourhood_);
  if (program_.has(Purpose::decomposition)) parts_ = program_.rules_of(Purpose::decomposition).data();
  if (!begin() || !locate()) now_ = {};
  at_rest_ = now_.active_count == 0;
  if (options_.watcher != nullptr) options_.watcher->begins(now_.string);
}

// Reserves room in `next_` for a run and a successor. Inline, as the innermost loop: else it takes a tenth longer.
inline bool Derivation::make_room(std::uint64_t run, const Template& successor) {
  const std::uint64_t words = next_.string.used + run + successor.words;
  const std::uint64_t active = next_.active_count + successor.active.size();
  return machine_.make_room(next_.string.words, words) && machine_.make_room(next_.active, active);
}

// Copies the words of `now_` from the last copied one to before `at` to the end of `next_`.
inline bool Derivation::copy_up_to(std::uint64_t at) {
  const std::uint64_t count = at - copied_;
  copy_words(next_.string.words.data() + next_.string.used, now_.string.words.data() + copied_,
             static_cast<std::size_t>(count));
  next_.string.used += count;
  return true;
}

// Appends a successor and its active modules to `next_`, which has room for them (make_room); decomposes its modules if
// the text has decomposition rules. `origin` and `symbol` are those of the module that it replaces, `by` its
// production. Returns false with the machine's error.
inline bool Derivation::append(const Template& successor, const Origin& origin, std::uint32_t symbol,
                               const Production* by) {
  if (parts_ != nullptr) return append_parts(successor, origin, symbol, by, 0);
  String& string = next_.string;
  if (!machine_.write(successor, string.words.data() + string.used, origin, symbol)) return false;
  std::uint32_t* const list = next_.active.data() + next_.active_count;
  const std::uint32_t* const offsets = program_.active.data() + successor.active.begin;
  const std::uint32_t count = successor.active.size();
  for (std::uint32_t i = 0; i < count; ++i) list[i] = static_cast<std::uint32_t>(string.used) + offsets[i];
  next_.active_count += count;
  string.used += successor.words;
  string.modules += successor.modules;
  return true;
}

// Appends the successor of a production in place of the module at a word, and reports each step to the watcher.
[[gnu::noinline]] bool Derivation::append_watched(std::uint64_t at, const Production& by, const Origin& origin,
                                                  std::uint32_t symbol) {
  Watcher& watcher = *options_.watcher;
  const std::uint64_t before = next_.string.modules;
  watcher.rewrites(at);
  if (!append(by.successor, origin, symbol, &by)) return false;
  if (parts_ == nullptr) watcher.applied(by, machine_);
  watcher.rewritten(next_.string.modules - before);
  return true;
}

// Appends a successor whose modules are decomposed, recursively up to the depth of the text. It is written `by` a
// production, or null.
bool Derivation::append_parts(const Template& successor, const Origin& origin, std::uint32_t symbol,
                              const Production* by, std::uint32_t depth) {
  if (part_words_.size() <= depth) part_words_.resize(depth + 1);
  if (!machine_.make_room(part_words_[depth], successor.words) ||
      !machine_.write(successor, part_words_[depth].data(), origin, symbol))
    return false;
  Watcher* const watcher = options_.watcher;
  if (watcher != nullptr && by != nullptr && depth == 0) watcher->applied(*by, machine_);
  const std::uint32_t* at = part_words_[depth].data();
  const std::uint32_t* const end = at + successor.words;
  for (; at < end; at += words_of(*at)) {
    const bool parted = depth < bound_.depths[0] && parts_[symbol_of(*at)].productions.size() > 0;
    const Production* const production = parted ? machine_.choose(at, parts_) : nullptr;
    if (machine_.failed()) return false;
    if (watcher != nullptr && production == nullptr) watcher->part(by);
    const bool fine =
        production == nullptr
            ? append_module(at)
            : machine_.spend(1) && append_parts(production->successor, has_lineage(*at) ? origin_of(at) : Origin{},
                                                symbol_of(*at), production, depth + 1);
    if (!fine) return false;
  }
  return true;
}

// Copies one module to the end of `next_`, makes room for it, and lists it as active if a production or a % may act on
// it in the next step. Returns false with the machine's error.
bool Derivation::append_module(const std::uint32_t* module) {
  String& string = next_.string;
  const std::uint32_t words = words_of(*module), symbol = symbol_of(*module);
  if (!machine_.make_room(string.words, string.used + words)) return false;
  if (symbol == cut_symbol || program_.rules[symbol].productions.size() > 0) {
    if (!machine_.make_room(next_.active, next_.active_count + 1)) return false;
    next_.active.data()[next_.active_count++] = static_cast<std::uint32_t>(string.used);
  }
  copy_words(string.words.data() + string.used, module, words);
  string.used += words;
  ++string.modules;
  return true;
}

// Writes the turtle's state into ?P and the like, so that the next step can use it.
bool Derivation::locate() {
  if (!program_.locates || machine_.failed()) return !machine_.failed();
  const Diagnostic error = lsystem::locate(bound_, now_.string, options_.start, seed_, limits_, options_.space);
  if (error.reason != Reason::none) return machine_.fail(error);
  return machine_.spend(now_.string.used / 32);
}

// Writes the axiom.
bool Derivation::begin() {
  const Template& axiom = program_.axiom;
  const std::uint64_t root = hash_text("axiom");
  machine_.begin(root);
  if (!make_room(0, axiom) || !append(axiom, {root, no_symbol << 16 | no_symbol}, no_symbol, nullptr)) return false;
  std::swap(now_, next_);
  return true;
}

// Takes one derivation step. Returns whether any module was rewritten; false also if the step failed: see `error()`.
bool Derivation::step() {
  if (machine_.failed()) return false;
  rewrote_ = waiting_ = false;
  if (!at_rest_ && !rewrite()) {
    at_rest_ = true;
    return false;
  }
  if (rewrote_ && !locate()) {  // the step is not whole: its string gives way to the one before
    std::swap(now_, next_);
    at_rest_ = true;
    return false;
  }
  at_rest_ = now_.active_count == 0 || !(rewrote_ || waiting_);
  answered_ = false;
  ++steps_;
  if (options_.watcher != nullptr) options_.watcher->ends(now_.string);
  return rewrote_;
}

// Interprets the string, sends the queries of ?E modules to the environment and writes its responses into them. Returns
// false with the machine's error.
bool Derivation::query_environment(const Turtle& start, Listener& listener) {
  if (machine_.failed()) return false;
  if (listener.observes_first()) {
    listener.observation_begins();
    const auto heard = interpret_without_queries(bound_, now_.string, start, listener, seed_, limits_, options_.space);
    if (!heard) return machine_.fail(heard.error());
    listener.responses_begin();
  }
  if (options_.watcher != nullptr) options_.watcher->queries();
  const Diagnostic error = write_responses(bound_, now_.string, start, listener, seed_, limits_, options_.space);
  if (error.reason != Reason::none) return machine_.fail(error);
  if (options_.watcher != nullptr) options_.watcher->responded();
  answered_ = true;
  at_rest_ = false;
  return true;
}

// Rewrites the active module at a word of `now_`: copies the unchanged modules before it, then appends the successor of
// its production. Without a production the module is copied later, and remains active if a later step may rewrite it. A
// ?E without a response since the last step has no production. Returns false with the machine's error.
inline bool Derivation::rewrite_module(std::uint64_t at) {
  const std::uint32_t* const module = now_.string.words.data() + at;
  const std::uint32_t header = *module;
  if (symbol_of(header) == cut_symbol) return cut(at);
  const bool unanswered = symbol_of(header) == query_symbol && !answered_;
  if (program_.rules[symbol_of(header)].in_context && !look_around(at)) return false;
  const Production* const production = unanswered ? nullptr : machine_.choose(module);
  if (production == nullptr) return !machine_.failed() && (!stays_active(header) || keep_active(at));
  if (!make_room(at - copied_, production->successor) || !copy_up_to(at)) return false;
  copied_ = at + words_of(header);
  --next_.string.modules;
  rewrote_ = true;
  const Origin origin = has_lineage(header) ? origin_of(module) : Origin{};
  if (options_.watcher != nullptr) return append_watched(at, *production, origin, symbol_of(header));
  return append(production->successor, origin, symbol_of(header), production);
}

// Rewrites all active modules of `now_` into `next_`, and swaps both. Returns false with the machine's error.
bool Derivation::rewrite() {
  if (chance_ == Chance::each_step) machine_.decide_at(steps_);
  if (program_.in_context && !(machine_.spend(now_.string.used / 32) && neighbourhood_.begin(now_.string)))
    return machine_.failed() ? false : out_of_sight();
  if (!machine_.spend(now_.active_count / 16)) return false;
  next_.string.used = next_.active_count = copied_ = 0;
  next_.string.modules = now_.string.modules;
  make_ready();
  for (std::uint64_t i = 0; i < now_.active_count; ++i) {
    const std::uint64_t at = now_.active.data()[i];
    if (at >= copied_ && !rewrite_module(at)) return false;  // before it: was cut
  }
  if (!rewrote_) {  // and the places of those that stay active are those in `now_`
    std::swap(now_.active, next_.active);
    now_.active_count = next_.active_count;
    return true;
  }
  if (!make_room(now_.string.used - copied_, {}) || !copy_up_to(now_.string.used)) return false;
  if (!machine_.spend(next_.string.used / 32)) return false;
  std::swap(now_, next_);
  return true;
}

// Lists the module at a word of `now_` as active in the next step, too.
bool Derivation::keep_active(std::uint64_t at) {
  const std::uint32_t header = now_.string.words.data()[at];
  waiting_ |= symbol_of(header) != query_symbol && machine_.tries_again(header);
  if (!machine_.make_room(next_.active, next_.active_count + 1)) return false;
  next_.active.data()[next_.active_count++] = static_cast<std::uint32_t>(next_.string.used + at - copied_);
  return true;
}

// Whether a module without a production may be rewritten in a later step.
bool Derivation::stays_active(std::uint32_t header) const {
  return symbol_of(header) == query_symbol || program_.rules[symbol_of(header)].in_context ||
         program_.is_turtle_query(symbol_of(header)) || machine_.tries_again(header);
}

// Moves the neighbourhood to the module at a word. Counts the way there as work, also in steps that rewrite nothing:
// chance may let many of them follow.
bool Derivation::look_around(std::uint64_t at) {
  neighbourhood_.go_to(at, walked_);
  const std::uint64_t units = walked_ / 32;
  walked_ %= 32;
  return machine_.spend(units);
}

// Fails since there is no memory for the neighbourhood.
bool Derivation::out_of_sight() {
  return machine_.fail(
      error_at(Reason::limit, {}, message(messages::lsystem::no_memory_for_contexts, now_.string.modules)));
}

// Skips the % at `at` and the rest of its branch: up to the closing bracket, or to the end.
bool Derivation::cut(std::uint64_t at) {
  if (!make_room(at - copied_, {}) || !copy_up_to(at)) return false;
  const std::uint32_t* const string = now_.string.words.data();
  const RestOfBranch rest = rest_of_branch(string + at, string + now_.string.used);
  copied_ = static_cast<std::uint64_t>(rest.end - string);
  next_.string.modules -= rest.modules;
  rewrote_ = true;
  if (options_.watcher != nullptr) options_.watcher->removes(at, rest.modules);
  return true;
}

// Reserves the likely size of the step's result while the buffer is empty: a growing string about doubles.
void Derivation::make_ready() {
  const std::uint64_t most = now_.string.used + now_.active_count * program_.longest_successor;
  const std::uint64_t likely = std::min(most, 2 * now_.string.used + program_.longest_successor);
  next_.string.words.empty_for(std::min<std::uint64_t>(likely, limits_.words), limits_.words);
}

namespace {

// Takes steps up to `steps`, or until nothing is rewritten any more.
void derive(Derivation& derivation, std::uint32_t steps, const DerivationOptions& options, Derived& derived) {
  while (derivation.steps() < steps && (!derivation.at_rest() || options.environment != nullptr)) {
    if (options.environment != nullptr && !derivation.query_environment(options.start, *options.environment)) break;
    if (derivation.step()) {
      derived.steps = derivation.steps();
      derived.modules_written += length(derivation.string());
    } else if (derivation.at_rest() && options.environment != nullptr) {
      break;
    }
  }
  derived.stopped = derivation.error();
}

// Adds the last string of a derivation to its result.
Derived with_string(Derived derived, Derivation&& derivation) {
  derived.string = std::make_shared<const String>(std::move(derivation).take_string());
  return derived;
}

// Derives a string in a number of steps or, without one, until nothing is rewritten any more. A limit or an error is
// not a failed result: it is in `stopped`, beside the last whole string.
Result<Derived> derive(const BoundProgram& bound, std::uint64_t seed, std::optional<std::uint32_t> steps,
                       const Limits& limits, const DerivationOptions& options) {
  const bool to_rest = !steps;
  WorkBudget own(limits.work, limits.bytes);
  const Limits counted = limits.counted_by(own);
  Derivation derivation(bound, seed, counted, to_rest ? Derivation::Chance::once : Derivation::Chance::each_step,
                        options);
  Derived derived;
  derive(derivation, steps.value_or(limits.steps), options, derived);
  if (derived.stopped.reason == Reason::none && to_rest && !derivation.at_rest())
    derived.stopped = Machine::too_many_steps(limits);
  return with_string(std::move(derived), std::move(derivation));
}

// The result, or its error if the derivation stopped early.
Result<Derived> error_if_stopped(Result<Derived> derived) {
  if (derived && derived->stopped.reason != Reason::none) return derived->stopped;
  return derived;
}

// The result of unfolding or, if a limit ends that, of steps. Each has half of the work that is left: so steps lead to
// the same string with and without a watcher.
Result<Derived> unfold_or_derive(const BoundProgram& bound, std::uint64_t seed, const Limits& limits,
                                 const DerivationOptions& options) {
  WorkBudget own(limits.work, limits.bytes);
  const Limits shared = limits.counted_by(own);
  const std::uint64_t half = shared.budget->left() / 2;
  if (options.watcher == nullptr) {
    const WorkBudget::Share share(*shared.budget, half);
    Result<Derived> unfolded = unfold(bound, seed, shared, options);
    if (unfolded || unfolded.error().reason != Reason::limit) return unfolded;
  }
  const WorkBudget::Share share(*shared.budget, half);
  return derive(bound, seed, {}, shared, options);
}

// The requested number of steps, else that of the text, if any.
std::optional<std::uint32_t> steps_of(const BoundProgram& bound, std::optional<std::uint32_t> requested) {
  return requested ? requested : derivation_length(bound);
}

// The error of a request for too many steps.
Diagnostic too_many_steps(std::uint32_t steps, const Limits& limits) {
  return error_at(Reason::limit, {}, message(messages::lsystem::request_over_limit, steps, limits.steps));
}

}  // namespace

// Derives until nothing is rewritten any more.
Result<Derived> develop_to_rest(const BoundProgram& bound, std::uint64_t seed, const Limits& limits,
                                const DerivationOptions& options) {
  return error_if_stopped(derive(bound, seed, {}, limits, options));
}

// Derives the requested number of steps, else those of the text, else unfolds the axiom completely. An early stop is an
// error.
Result<Derived> develop(const BoundProgram& bound, std::uint64_t seed, std::optional<std::uint32_t> requested,
                        const Limits& limits, const DerivationOptions& options) {
  const std::optional<std::uint32_t> steps = steps_of(bound, requested);
  if (!steps) return unfold(bound, seed, limits, options);
  if (*steps > limits.steps) return too_many_steps(*steps, limits);
  return error_if_stopped(derive(bound, seed, steps, limits, options));
}

// The same, but a limit that stops the derivation is not an error: the result is the last whole string.
Result<Derived> develop_so_far(const BoundProgram& bound, std::uint64_t seed, std::optional<std::uint32_t> requested,
                               const Limits& limits, const DerivationOptions& options) {
  const std::optional<std::uint32_t> steps = steps_of(bound, requested);
  if (steps && *steps > limits.steps) return too_many_steps(*steps, limits);
  Result<Derived> derived =
      steps ? derive(bound, seed, steps, limits, options) : unfold_or_derive(bound, seed, limits, options);
  if (derived && derived->stopped.reason != Reason::none && derived->stopped.reason != Reason::limit)
    return derived->stopped;
  return derived;
}

// The number of modules of a string.
std::uint64_t length(const String& string) { return string.modules; }

}  // namespace panicle::lsystem
