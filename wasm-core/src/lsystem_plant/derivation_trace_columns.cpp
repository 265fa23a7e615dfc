#include "lsystem_plant/derivation_trace_columns.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace panicle {
namespace {

using lsystem::ToldModule;
using Words = std::vector<std::uint32_t>;

std::string lines_of(const std::vector<ToldModule>& modules, std::string ToldModule::* text) {
  std::string all;
  for (const ToldModule& told : modules) {
    if (&told != modules.data()) all += '\n';
    all += told.*text;
  }
  return all;
}

// One line for each module: its refusals as `3:1 its condition is false`, separated by tabs.
std::string refusals_of(const std::vector<ToldModule>& modules) {
  std::string all;
  for (const ToldModule& told : modules) {
    if (&told != modules.data()) all += '\n';
    for (const lsystem::Refusal& refusal : told.refusals) {
      if (&refusal != told.refusals.data()) all += '\t';
      all += std::to_string(refusal.production.line) + ':' + std::to_string(refusal.production.column) + ' ';
      all += refusal.reason;
    }
  }
  return all;
}

Words pairs_of(const std::vector<ToldModule>& modules, expression::Place ToldModule::* place) {
  return column_of<std::uint32_t>(modules, 2, [place](const ToldModule& told, std::uint32_t* at) {
    at[0] = (told.*place).line;
    at[1] = (told.*place).column;
  });
}

Words pairs_of(const std::vector<ToldModule>& modules, lsystem::ModuleSpan ToldModule::* span) {
  return column_of<std::uint32_t>(modules, 2, [span](const ToldModule& told, std::uint32_t* at) {
    at[0] = (told.*span).first;
    at[1] = (told.*span).count;
  });
}

}  // namespace

Result<std::optional<lsystem::ChronicleAsked>> read_chronicle(Request& request) {
  using lsystem::ChronicleAsked;
  ChronicleAsked asked;
  asked.step = request.word("chronicle_step");
  asked.first = request.word("chronicle_first");
  asked.count = request.word("chronicle_count", ChronicleAsked::most);
  if (request.has("chronicle_module")) asked.module = request.word("chronicle_module");
  if (!request.wants("chronicle")) return std::optional<ChronicleAsked>();
  if (asked.count > ChronicleAsked::most)
    return Diagnostic{
        Reason::bad_request,
        "At most " + std::to_string(ChronicleAsked::most) + " modules of a derivation are told at once; ask for fewer.",
        0, 0};
  return std::optional(asked);
}

std::string cut_short(const lsystem::Chronicle& chronicle) {
  return "The derivation is told as far as it goes in steps. " + chronicle.stopped().message;
}

void add_chronicle(Plant& plant, const lsystem::Chronicle& chronicle) {
  const std::vector<ToldModule>& modules = chronicle.modules();
  Columns& columns = plant.columns;
  columns.add("chronicle.window",
              Words{chronicle.step(), chronicle.first(), static_cast<std::uint32_t>(modules.size())});
  columns.add("chronicle.counts", chronicle.counts());
  columns.add("chronicle.modules", lines_of(modules, &ToldModule::text));
  columns.add("chronicle.parent", column_of<std::uint32_t>(modules, 1, [](const ToldModule& told, std::uint32_t* at) {
                *at = told.parent;
              }));
  columns.add("chronicle.production", pairs_of(modules, &ToldModule::production), 2);
  columns.add("chronicle.fires", pairs_of(modules, &ToldModule::fires), 2);
  columns.add("chronicle.refusals", refusals_of(modules));
  columns.add("chronicle.values", lines_of(modules, &ToldModule::values));
  columns.add(
      "chronicle.chance",
      column_of<float>(
          modules, 3, [](const ToldModule& told, float* at) { std::copy(told.chance.begin(), told.chance.end(), at); }),
      3);
  columns.add("chronicle.children", pairs_of(modules, &ToldModule::children), 2);
  columns.add("chronicle.last", pairs_of(modules, &ToldModule::last), 2);
  columns.add("chronicle.answers", lines_of(modules, &ToldModule::answer));
  if (!chronicle.trail().empty()) columns.add("chronicle.trail", chronicle.trail());
}

}  // namespace panicle
