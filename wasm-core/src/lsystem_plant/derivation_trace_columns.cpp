#include "lsystem_plant/derivation_trace_columns.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "lsystem_plant/messages.generated.hpp"

namespace panicle {
namespace {

using lsystem::TraceEntry;
using Words = std::vector<std::uint32_t>;

// One of the texts of each module, a line each.
std::string lines_of(const std::vector<TraceEntry>& modules, std::string TraceEntry::* text) {
  std::string all;
  for (const TraceEntry& entry : modules) {
    if (&entry != modules.data()) all += '\n';
    all += entry.*text;
  }
  return all;
}

// A line for each module: the productions that did not fit it, as `3:1 the condition is false`, separated by tabs.
std::string refusals_of(const std::vector<TraceEntry>& modules) {
  std::string all;
  for (const TraceEntry& entry : modules) {
    if (&entry != modules.data()) all += '\n';
    for (const lsystem::Refusal& refusal : entry.refusals) {
      if (&refusal != entry.refusals.data()) all += '\t';
      all += std::to_string(refusal.production.line) + ':' + std::to_string(refusal.production.column) + ' ';
      all += refusal.reason;
    }
  }
  return all;
}

// For each module the line and column of one of its source locations.
Words pairs_of(const std::vector<TraceEntry>& modules, expression::SourceLocation TraceEntry::* place) {
  return column_of<std::uint32_t>(modules, 2, [place](const TraceEntry& entry, std::uint32_t* at) {
    at[0] = (entry.*place).line;
    at[1] = (entry.*place).column;
  });
}

// For each module the first index and the number of one of its spans of modules.
Words pairs_of(const std::vector<TraceEntry>& modules, lsystem::ModuleSpan TraceEntry::* span) {
  return column_of<std::uint32_t>(modules, 2, [span](const TraceEntry& entry, std::uint32_t* at) {
    at[0] = (entry.*span).first;
    at[1] = (entry.*span).count;
  });
}

}  // namespace

// The part of the derivation that the request wants traced; none if it wants no trace.
Result<std::optional<lsystem::TraceRequest>> read_trace_request(Request& request) {
  using lsystem::TraceRequest;
  TraceRequest trace;
  trace.step = request.word("chronicle_step");
  trace.first = request.word("chronicle_first");
  trace.count = request.word("chronicle_count", TraceRequest::most);
  if (request.has("chronicle_module")) trace.module = request.word("chronicle_module");
  if (!request.wants("chronicle")) return std::optional<TraceRequest>();
  if (trace.count > TraceRequest::most)
    return bad_request(message(messages::lsystem_plant::trace_window_too_long, TraceRequest::most));
  return std::optional(trace);
}

// The note that the trace ended early, and why.
std::string cut_short(const lsystem::DerivationTrace& trace) {
  return message(messages::lsystem_plant::trace_cut_short).encoded() + " " + trace.stopped().message;
}

// Adds the trace's columns, which the header lists.
void add_trace_columns(Plant& plant, const lsystem::DerivationTrace& trace) {
  const std::vector<TraceEntry>& modules = trace.modules();
  Columns& columns = plant.columns;
  columns.add("chronicle.window", Words{trace.step(), trace.first(), static_cast<std::uint32_t>(modules.size())});
  columns.add("chronicle.counts", trace.counts());
  columns.add("chronicle.modules", lines_of(modules, &TraceEntry::text));
  columns.add("chronicle.parent", column_of<std::uint32_t>(modules, 1, [](const TraceEntry& entry, std::uint32_t* at) {
                *at = entry.parent;
              }));
  columns.add("chronicle.production", pairs_of(modules, &TraceEntry::production), 2);
  columns.add("chronicle.fires", pairs_of(modules, &TraceEntry::fires), 2);
  columns.add("chronicle.refusals", refusals_of(modules));
  columns.add("chronicle.values", lines_of(modules, &TraceEntry::values));
  columns.add("chronicle.chance",
              column_of<float>(
                  modules, 3,
                  [](const TraceEntry& entry, float* at) { std::copy(entry.chance.begin(), entry.chance.end(), at); }),
              3);
  columns.add("chronicle.children", pairs_of(modules, &TraceEntry::children), 2);
  columns.add("chronicle.last", pairs_of(modules, &TraceEntry::last), 2);
  columns.add("chronicle.answers", lines_of(modules, &TraceEntry::response));
  if (!trace.trail().empty()) columns.add("chronicle.trail", trace.trail());
}

}  // namespace panicle
