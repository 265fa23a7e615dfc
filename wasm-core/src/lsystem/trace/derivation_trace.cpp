#include "lsystem/trace/derivation_trace.hpp"

#include <algorithm>
#include <utility>

#include "expression/code.hpp"
#include "expression/number_text.hpp"
#include "lsystem/derivation/machine.hpp"
#include "lsystem/derivation/string_text.hpp"
#include "lsystem/syntax/parser.hpp"

namespace panicle::lsystem {
namespace {

// The parameters of a module as text, each after a space.
std::string parameters_text(const std::uint32_t* module) {
  float parameters[max_parameters];
  std::memcpy(parameters, module + 1, parameters_of(*module) * sizeof(float));
  return numbers_text({parameters, parameters_of(*module)});
}

}  // namespace

// Numbers as text, each after a space.
std::string numbers_text(std::span<const float> numbers) {
  std::string text;
  for (const float number : numbers) {
    text += ' ';
    text += number_text(number);
  }
  return text;
}

// Begins the trace with the axiom, which is step 0; `parts_` has the production that wrote each of its modules.
void DerivationTrace::begins(const String& string) {
  counts_ = {static_cast<std::uint32_t>(string.modules)};
  if (is_traced_step()) {
    for (std::uint32_t i = request_.first; i < parts_.size() && written_.size() < request_.count; ++i)
      write(TraceEntry::none, parts_[i]);
    take_window(string);
  }
  parts_.clear();
  begin_step(string);
}

// Ends a step: records that the modules behind the last rewritten one were copied unchanged, and takes the window where
// this is the traced step.
void DerivationTrace::ends(const String& string) {
  find_refusals_once();  // the string is the one before where nothing was rewritten
  record_copied_until(counts_.back());
  for (; border_ < borders_.size(); ++border_) borders_[border_] = new_;
  counts_.push_back(static_cast<std::uint32_t>(string.modules));
  changes_end_.push_back(changes_.size());
  whole_borders_ = borders_;
  if (is_traced_step()) take_window(string);
  begin_step(string);
}

// Begins a step at the start of the string.
void DerivationTrace::begin_step(const String& string) {
  string_ = &string;
  word_ = index_ = old_ = new_ = 0;
  border_ = 0;
  answered_ = false;
}

// Finds the reasons why productions do not rewrite the window's modules, before the step changes anything.
void DerivationTrace::find_refusals_once() {
  if (!is_traced_step() || std::exchange(refused_, true)) return;
  std::optional<std::uint32_t> step;
  if (by_steps_) step = request_.step;
  // With a budget of their own: they leave the work of the derivation and of later stages unchanged.
  WorkBudget budget(limits_.work, limits_.bytes, limits_.budget == nullptr ? nullptr : limits_.budget->clock());
  Limits own_limits = limits_;
  own_limits.budget = &budget;
  Refusals refusals(*bound_, seed_, own_limits, space_, *string_, step, answered_);
  for (std::size_t i = 0; i < modules_.size(); ++i) modules_[i].refusals = refusals.of(words_[i]);
}

// The index of the module at a word; calls must be in ascending order.
std::uint32_t DerivationTrace::index_of(std::uint64_t word) {
  for (; word_ < word; ++index_) word_ += words_of(string_->begin()[word_]);
  return index_;
}

// The entry of a module in the traced window; null if it is outside.
TraceEntry* DerivationTrace::find_entry(std::uint32_t index) {
  const bool in_window =
      string_ != nullptr && is_traced_step() && index >= request_.first && index - request_.first < modules_.size();
  return in_window ? &modules_[index - request_.first] : nullptr;
}

// Notes that the module at a word is rewritten next.
void DerivationTrace::rewrites(std::uint64_t at) {
  if (string_ == nullptr) return;  // neither a step nor a drawing is watched
  rewriting_ = index_of(at);
  if (drawing_ == nullptr) {
    find_refusals_once();
    record_copied_until(rewriting_);
  }
  parts_.clear();
}

// Records the production that is applied, with the values of its names.
void DerivationTrace::applied(const Production& production, const Machine& machine) {
  production_ = &production;
  TraceEntry* const entry = find_entry(rewriting_);
  if (entry == nullptr) return;
  entry->fires = production.place;
  entry->values = values_of(production, machine);
  if (production.weight.given) entry->chance = machine.chance();
}

// Records the modules that replace the rewritten one. Without decomposition the applied production writes all of them.
void DerivationTrace::rewritten(std::uint64_t modules) {
  const auto count = static_cast<std::uint32_t>(modules);
  for (std::uint32_t i = 0; is_before_traced_step() && i < count; ++i)
    if (new_ + i >= request_.first) write(rewriting_, i < parts_.size() ? parts_[i] : production_);
  change(1, count);
}

// Records that a % removes modules.
void DerivationTrace::removes(std::uint64_t at, std::uint64_t modules) {
  find_refusals_once();
  record_copied_until(index_of(at));
  change(static_cast<std::uint32_t>(modules), 0);
}

// Adds the window's next module.
void DerivationTrace::write(std::uint32_t parent, const Production* production) {
  if (written_.size() >= request_.count) return;
  written_.emplace_back().parent = parent;
  if (production != nullptr) written_.back().production = production->place;
}

// Records that the modules from the previous change up to `index` were copied unchanged: they have one child each, and
// the borders between the descendants of traced modules move along.
void DerivationTrace::record_copied_until(std::uint32_t index) {
  const std::int64_t moved = std::int64_t{new_} - old_;
  const auto overlap = [&](std::int64_t first, std::size_t count, const auto& each) {
    const std::int64_t end = std::min<std::int64_t>(index, first + static_cast<std::int64_t>(count));
    for (std::int64_t i = std::max<std::int64_t>(old_, first); i < end; ++i) each(static_cast<std::uint32_t>(i));
  };
  if (is_before_traced_step())
    overlap(request_.first - moved, request_.count, [&](std::uint32_t i) { write(i, nullptr); });
  if (is_traced_step())
    overlap(request_.first, modules_.size(),
            [&](std::uint32_t i) { find_entry(i)->children = {static_cast<std::uint32_t>(i + moved), 1}; });
  for (; border_ < borders_.size() && borders_[border_] < index; ++border_)
    borders_[border_] = static_cast<std::uint32_t>(borders_[border_] + moved);
  new_ += index - old_;
  old_ = index;
}

// Records that the next `removed` modules of the string before have become `written` in the one after.
void DerivationTrace::change(std::uint32_t removed, std::uint32_t written) {
  for (std::uint32_t i = 0; i < removed; ++i)
    if (TraceEntry* const entry = find_entry(old_ + i)) entry->children = {new_, written};
  for (; border_ < borders_.size() && borders_[border_] < old_ + removed; ++border_) borders_[border_] = new_;
  old_ += removed;
  new_ += written;
  if (request_.module && changes_.size() < max_rewritten) changes_.push_back({old_ - removed, old_, new_});
}

// Takes the modules of the requested window from the string of the traced step.
void DerivationTrace::take_window(const String& string) {
  const std::uint32_t count = counts_.back(), first = std::min(request_.first, count);
  written_.resize(std::min(request_.count, count - first));
  modules_ = std::move(written_);
  borders_.clear();
  for (std::uint32_t i = 0; i <= modules_.size(); ++i) borders_.push_back(first + i);
  whole_borders_ = borders_;
  const std::uint32_t* at = string.begin();
  for (std::uint32_t i = 0; i < first; ++i) at += words_of(*at);
  for (TraceEntry& entry : modules_) {
    words_.push_back(static_cast<std::uint64_t>(at - string.begin()));
    entry.text = module_text(*program_, at);
    if (program_->is_turtle_query(symbol_of(*at))) entry.response = "written" + parameters_text(at);
    at += words_of(*at);
  }
}

// The values with which a production was applied, of its parameters and of the names assigned in its blocks: `n=3
// t=0.5`.
std::string DerivationTrace::values_of(const Production& production, const Machine& machine) const {
  const Range names = program_->named_in[static_cast<std::size_t>(&production - program_->productions.data())];
  std::string text;
  for (std::uint32_t i = names.begin; i < names.end; ++i) {
    const Naming& naming = program_->namings[i];
    if (i > names.begin) text += ' ';
    text += naming.name;
    text += '=';
    text += number_text(machine.value_of(naming.source));
  }
  return text;
}

// Notes the parameters of the window's modules before the responses of the environment.
void DerivationTrace::queries() {
  queries_.clear();
  for (std::size_t i = 0; is_traced_step() && i < words_.size(); ++i)
    queries_.push_back(parameters_text(string_->begin() + words_[i]));
}

// Records the responses beside the queries.
void DerivationTrace::responded() {
  answered_ = true;
  for (std::size_t i = 0; i < queries_.size(); ++i) {
    const std::uint32_t* const module = string_->begin() + words_[i];
    if (symbol_of(*module) != query_symbol) continue;
    modules_[i].response = "asked" + queries_[i] + " →" + parameters_text(module);
  }
}

// Completes the trace after the last step, and follows the requested module back to its ancestors.
void DerivationTrace::finish(std::uint32_t steps, const Diagnostic& stopped, const String& last) {
  stopped_ = stopped;
  counts_.resize(std::min<std::size_t>(counts_.size(), steps + 1));
  string_ = &last;
  find_refusals_once();
  string_ = nullptr;
  bound_ = nullptr;
  space_ = nullptr;
  // Removes the traces of a step that never ended.
  for (std::uint32_t i = 0; is_traced_step() && i < modules_.size(); ++i) {
    TraceEntry& entry = modules_[i];
    entry.fires = {};
    entry.values.clear();
    entry.chance = {};
    entry.children = {};
  }
  for (std::size_t i = 0; i < modules_.size(); ++i)
    modules_[i].last = {whole_borders_[i], whole_borders_[i + 1] - whole_borders_[i]};
  if (!request_.module || *request_.module >= counts_.back() || changes_.size() >= max_rewritten) return;
  trail_.assign(counts_.size(), *request_.module);
  for (std::uint32_t step = this->steps(); step-- > 0;) trail_[step] = ancestor_of(trail_[step + 1], step);
}

// Returns the ancestor in the string of `step` of a module of the next string.
std::uint32_t DerivationTrace::ancestor_of(std::uint32_t module, std::uint32_t step) const {
  const auto begin = changes_.begin() + static_cast<std::ptrdiff_t>(step == 0 ? 0 : changes_end_[step - 1]);
  const auto end = changes_.begin() + static_cast<std::ptrdiff_t>(changes_end_[step]);
  const auto found = std::upper_bound(begin, end, module,
                                      [](std::uint32_t index, const Change& change) { return index < change.new_end; });
  const Change before = found == begin ? Change{} : *(found - 1);
  const bool copied = found == end || module - before.new_end < found->old_begin - before.old_end;
  return copied ? before.old_end + (module - before.new_end) : found->old_begin;
}

// Begins to record the responses while the last string is drawn.
void DerivationTrace::watch_drawing(std::shared_ptr<const String> last) {
  drawing_ = std::move(last);
  begin_step(*drawing_);
}

// Adds the response that a module got in drawing.
void DerivationTrace::add_response(std::uint32_t module, std::string_view response) {
  if (TraceEntry* const entry = find_entry(module)) entry->response += response;
}

// Derives again with a trace of the requested step and window of modules; of the last step if there are fewer.
Result<DerivationTrace> trace_derivation(const BoundProgram& bound, std::uint64_t seed,
                                         std::optional<std::uint32_t> steps, const Limits& limits,
                                         const DerivationOptions& options, TraceRequest request) {
  const WorkBudget::TimePassed clock = limits.budget == nullptr ? nullptr : limits.budget->clock();
  for (;;) {
    const bool by_steps = steps || derivation_length(bound);
    DerivationTrace trace(bound, seed, limits, options.space, by_steps, request);
    DerivationOptions watched = options;
    watched.watcher = &trace;
    // With a budget of its own, so that it comes as far as the derivation that is traced.
    WorkBudget budget(limits.work, limits.bytes, clock);
    Limits own = limits;
    own.budget = &budget;
    const auto derived = develop_so_far(bound, seed, steps, own, watched);
    if (!derived) return derived.error();
    // Steps that rewrote nothing change nothing but responses.
    trace.finish(options.environment == nullptr ? derived->steps : trace.steps(), derived->stopped, *derived->string);
    if (request.step <= trace.steps()) return trace;
    request.step = trace.steps();
  }
}

}  // namespace panicle::lsystem
