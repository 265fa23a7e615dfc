// A trace of a derivation: for a step and a window of its string, where each module came from, the production that
// rewrites it with its values, its descendants and the responses to its queries. It watches a real derivation.
//
// No string is stored: for another step the derivation is repeated.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lsystem/derivation/derivation.hpp"
#include "lsystem/derivation/watcher.hpp"
#include "lsystem/trace/refusals.hpp"

namespace panicle::lsystem {

struct TraceRequest {
  static constexpr std::uint32_t most = 2000;  // modules of a window

  std::uint32_t step = 0;                    // 0 is the axiom; beyond the last: the last
  std::uint32_t first = 0, count = most;     // modules of its string
  std::optional<std::uint32_t> module = {};  // of the last string, whose ancestors are wanted
};

// A range of modules.
struct ModuleSpan {
  std::uint32_t first = 0, count = 0;
};

// A module of the window. Places are those of productions: 0, 0 for none.
struct TraceEntry {
  static constexpr std::uint32_t none = 0xffffffff;

  std::string text;                  // as strings have it
  std::uint32_t parent = none;       // of the step before
  SourceLocation production;         // that wrote it in this step
  SourceLocation fires;              // that rewrites it next
  std::vector<Refusal> refusals;     // the other productions of its symbol
  std::string values;                // of its formals, then of the assignments of its blocks: `n=3 t=0.5`
  std::array<float, 3> chance = {};  // where it was drawn: the sum of all weights, its own, where in the sum it fell
  ModuleSpan children;               // in the next step
  ModuleSpan last;                   // in the last string
  std::string response;              // response to a query: `asked 1 0 → 1 3; why`, or `written 0 1 0`
};

class DerivationTrace final : public Watcher {
 public:
  static constexpr std::size_t max_rewritten = 4'000'000;  // in all steps, for ancestors to be found

  // `bound` and the space must last until `finish`. `by_steps`: whether each step draws anew (Derivation::Chance).
  DerivationTrace(const BoundProgram& bound, std::uint64_t seed, const Limits& limits, const Space* space,
                  bool by_steps, const TraceRequest& request)
      : program_(bound.program),
        bound_(&bound),
        seed_(seed),
        limits_(limits),
        space_(space),
        by_steps_(by_steps),
        request_(request) {}

  // The step that is traced, and the first module of the window.
  std::uint32_t step() const { return request_.step; }
  std::uint32_t first() const { return request_.first; }
  std::uint32_t steps() const { return static_cast<std::uint32_t>(counts_.size()) - 1; }
  // The numbers of modules of each step's string, the axiom's first.
  const std::vector<std::uint32_t>& counts() const { return counts_; }
  const std::vector<TraceEntry>& modules() const { return modules_; }
  // By step, the ancestor of the requested module; empty without such a request, where the last string has no such
  // module, or too much was rewritten.
  const std::vector<std::uint32_t>& trail() const { return trail_; }
  // The limit that cut the derivation short.
  const Diagnostic& stopped() const { return stopped_; }

  // Ends the trace of the derivation, when all strings but the last are freed. `steps`: the derivation's steps, without
  // final ones that did nothing.
  void finish(std::uint32_t steps, const Diagnostic& stopped, const String& last);
  // From now on it watches how the last string is drawn, and records the productions that are applied to responses.
  void watch_drawing(std::shared_ptr<const String> last);
  // Whether the window has this module of the last string, which is being drawn.
  bool has(std::uint32_t module) { return find_entry(module) != nullptr; }
  // Sets the query and response of a module while it is drawn, or appends to it.
  void add_response(std::uint32_t module, std::string_view response);

  void begins(const String& string) override;
  void ends(const String& string) override;
  // Before a module is rewritten: records that the modules since the previous rewritten one were copied unchanged.
  // While the last string is drawn it does not change, so only the module is noted.
  void rewrites(std::uint64_t at) override;
  void applied(const Production& production, const Machine& machine) override;
  // Records the production that makes the next part.
  void part(const Production* production) override { parts_.push_back(production); }
  void rewritten(std::uint64_t modules) override;
  void removes(std::uint64_t at, std::uint64_t modules) override;
  void queries() override;
  void responded() override;

 private:
  // A range of modules in the string before that becomes a range in the string after. Both begin behind the previous
  // change and the modules copied since.
  struct Change {
    std::uint32_t old_begin = 0, old_end = 0, new_end = 0;
  };

  bool is_traced_step() const { return steps() == request_.step; }
  bool is_before_traced_step() const { return steps() + 1 == request_.step; }
  TraceEntry* find_entry(std::uint32_t index);
  void begin_step(const String& string);
  void find_refusals_once();
  std::uint32_t index_of(std::uint64_t word);
  void record_copied_until(std::uint32_t index);
  void change(std::uint32_t removed, std::uint32_t written);
  void write(std::uint32_t parent, const Production* production);
  void take_window(const String& string);
  std::string values_of(const Production& production, const Machine& machine) const;
  std::uint32_t ancestor_of(std::uint32_t module, std::uint32_t step) const;

  std::shared_ptr<const Program> program_;
  const BoundProgram* bound_;  // null once it is finished
  std::uint64_t seed_;
  Limits limits_;
  const Space* space_;
  bool by_steps_;
  TraceRequest request_;
  std::vector<std::uint32_t> counts_;
  std::vector<TraceEntry> modules_;
  std::vector<std::uint32_t> trail_;
  Diagnostic stopped_;

  const String* string_ = nullptr;         // that is being rewritten or drawn; null: neither
  std::shared_ptr<const String> drawing_;  // the last string, while that is drawn
  std::uint64_t word_ = 0;                 // of the string: up to where modules have been counted
  std::uint32_t index_ = 0;
  std::uint32_t old_ = 0, new_ = 0;  // modules of the string before and after that are processed in this step
  std::uint32_t rewriting_ = 0;      // the module
  const Production* production_ = nullptr;
  bool answered_ = false;  // ?E, since the step before
  bool refused_ = false;   // whether the window has its refusals
  std::vector<const Production*> parts_;
  std::vector<TraceEntry> written_;           // of the window, the fields that are known before its string
  std::vector<std::uint64_t> words_;          // where the window's modules stand
  std::vector<std::string> queries_;          // parameters of their queries
  std::vector<std::uint32_t> borders_;        // where each one's descendants begin, and where those of the last end
  std::vector<std::uint32_t> whole_borders_;  // the same after the last whole step
  std::size_t border_ = 0;                    // the next that this step has to move
  std::vector<Change> changes_;               // of all steps, where ancestors are wanted
  std::vector<std::size_t> changes_end_;      // by step
};

// Numbers as responses show them: ` 1 0.5 3`.
std::string numbers_text(std::span<const float> numbers);

// Repeats a derivation, as `develop_so_far`, with a trace. Errors as there.
Result<DerivationTrace> trace_derivation(const BoundProgram& bound, std::uint64_t seed,
                                         std::optional<std::uint32_t> steps, const Limits& limits,
                                         const DerivationOptions& options, TraceRequest request);

}  // namespace panicle::lsystem
