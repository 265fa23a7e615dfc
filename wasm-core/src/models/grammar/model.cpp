#include "models/grammar/model.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lsystem/derivation/words.hpp"
#include "lsystem_plant/derivation_trace_columns.hpp"
#include "lsystem_plant/messages.generated.hpp"
#include "lsystem_plant/requested_program.hpp"
#include "models/grammar/area_membership.hpp"
#include "models/grammar/areas.hpp"
#include "models/grammar/dressing.hpp"
#include "models/grammar/girth.hpp"
#include "models/grammar/measures/measures.hpp"
#include "models/grammar/messages.generated.hpp"
#include "models/grammar/neighbours.hpp"
#include "models/grammar/parameters.generated.hpp"
#include "models/grammar/sketch.hpp"
#include "plant/fingerprint.hpp"
#include "protocol/common_request.hpp"
#include "protocol/parameter_values.hpp"

namespace panicle::grammar {

// The turtle is the moving pen that draws a string.

namespace {

using GrammarValues = Values<Parameter, parameter_table>;
using enum Parameter;

constexpr float metres_a_millimetre = 0.001f;
// Longest string that is written as text: a number takes up to half a microsecond.
constexpr std::uint64_t max_words_as_text = 4 * 1024 * 1024;

// Options of a request.
struct GrowOptions : CommonRequest {
  explicit GrowOptions(const CommonRequest& common) : CommonRequest(common) {}

  std::optional<std::uint32_t> steps;
  lsystem::Inputs inputs;
  bool coarse = false, string = false;
  std::optional<lsystem::TraceRequest> chronicle;
};

// Reads constants: one name a line, and one value a name.
Diagnostic read_constants(Request& request, lsystem::Inputs& inputs) {
  std::string_view names = request.text("constants.names");
  for (const float value : request.floats("constants.values")) {
    const std::size_t end = names.find('\n');
    if (names.empty()) return bad_request(message(messages::grammar::constants_unpaired));
    inputs.scalars.push_back({std::string(names.substr(0, end)), value});
    names = end == std::string_view::npos ? std::string_view() : names.substr(end + 1);
  }
  if (!names.empty()) return bad_request(message(messages::grammar::constants_unpaired));
  return {};
}

// Reads the options of a request besides its grammar. Errors: bad_request.
Result<GrowOptions> read(Request& request) {
  GrowOptions options(read_common(request));
  options.coarse = request.wants("coarse");
  options.string = request.wants("string");
  if (request.has("steps")) options.steps = request.word("steps");
  if (Diagnostic error = read_constants(request, options.inputs); error.reason != Reason::none) return error;
  auto chronicle = read_trace_request(request);
  if (!chronicle) return chronicle.error();
  options.chronicle = chronicle.value();
  return options;
}

// The turtle at the origin, heading up, with its left side at −X.
lsystem::Turtle initial_turtle() {
  lsystem::Turtle turtle;
  turtle.heading = {0, 1, 0};
  turtle.left = {-1, 0, 0};
  turtle.up = {0, 0, 1};
  turtle.width = no_width;
  return turtle;
}

// Limits for a plant that consists of drawn lines and organs alone: as many lines as particle trails, and as many balls
// as copies in trees.
Limits drawing_limits(Limits limits) {
  limits.segments = limits.pieces;
  limits.spheres = limits.copies;
  return limits;
}

// Adds the notes on areas and, for each line, the columns of its area and of whether it belongs to the main branch.
void add_area_columns(Plant& plant, const Sketch& sketch, const std::vector<AreaMembership>& all, const Areas& areas) {
  plant.notes.insert(plant.notes.end(), areas.notes().begin(), areas.notes().end());
  if (all.empty()) return;
  const auto of = [&](const Mark& mark) { return mark.module < all.size() ? all[mark.module] : AreaMembership{}; };
  plant.columns.add("segments.area", column_of<std::uint8_t>(sketch.lines, 1, [&](const Mark& mark, std::uint8_t* at) {
                      *at = of(mark).area;
                    }));
  plant.columns.add("segments.main", column_of<std::uint8_t>(sketch.lines, 1, [&](const Mark& mark, std::uint8_t* at) {
                      *at = of(mark).main ? 1 : 0;
                    }));
  std::vector<bool> grown(areas.size() + 1);
  for (const Mark& mark : sketch.lines)
    if (of(mark).area <= areas.size()) grown[of(mark).area] = true;
  for (std::size_t area = 1; area <= areas.size(); ++area) {
    if (grown[area]) continue;
    const std::size_t around = areas.around(area);
    plant.notes.push_back(around == 0 ? message(messages::grammar::area_not_reached, area)
                                      : message(messages::grammar::area_in_area, area, around));
  }
}

// The trace of the derivation, where it is requested.
Result<std::optional<lsystem::DerivationTrace>> trace_derivation(const lsystem::BoundProgram& bound,
                                                                 const GrowOptions& options, const Limits& limits,
                                                                 const lsystem::DerivationOptions& around) {
  if (!options.chronicle) return std::optional<lsystem::DerivationTrace>();
  Limits of_derivation = limits;
  of_derivation.work = limits.work_of_derivation();
  auto traced =
      lsystem::trace_derivation(bound, options.seed, options.steps, of_derivation, around, *options.chronicle);
  if (!traced) return traced.error();
  return std::optional(std::move(traced.value()));
}

constexpr ProgramOptions program_options{lsystem::Notation::cpfg, lsystem::Lineages::where_needed};

// Grows a plant from the text of an L-system: derives its string, lets the turtle draw it within the areas, and adds
// meshes and measures as requested.
Result<Plant> grow(Request& request, const Limits& given) {
  WorkBudget own(given.work, given.bytes);
  const Limits limits = drawing_limits(given).counted_by(own);
  const Result<GrowOptions> options = read(request);
  Result<Areas> areas = Areas::read(request, limits);
  const auto program = requested_program(request, program_options, limits);
  if (Diagnostic error = request.trouble(); error.reason != Reason::none) return error;
  if (!options) return options.error();
  if (!areas) return areas.error();
  if (!program) return program.error();
  Plant plant;
  const GrammarValues values(options->parameters, plant.notes);

  const float metres = metres_a_millimetre * values[unit];
  // Constants of the document, then inputs of the areas.
  lsystem::Inputs inputs = options->inputs;
  areas->add_inputs(inputs, metres);
  const auto bound = lsystem::bind(program.value(), inputs, limits);
  if (!bound) return bound.error();
  Neighbours neighbours(*limits.budget);
  const bool has_queries = lsystem::has_queries(*program.value());
  const lsystem::DerivationOptions around{initial_turtle(), &areas.value(), has_queries ? &neighbours : nullptr};
  const auto derived = [&] {
    const WorkBudget::Share share(*limits.budget, limits.work_of_derivation());
    return lsystem::develop_so_far(*bound.value(), options->seed, options->steps, limits, around);
  }();
  if (!derived) return derived.error();
  const lsystem::String& string = *derived->string;
  // Draws the string. A limit, unlike another error, cuts the plant short and leaves a note.
  Sketch sketch(limits);
  sketch.begin();
  const auto drawn = lsystem::interpret_without_queries(*bound.value(), string, initial_turtle(), sketch, options->seed,
                                                        limits, around.space);
  if (areas->is_exhausted()) return QueryBudget::error();
  const Diagnostic drawing_error = drawn ? Diagnostic{} : drawn.error();
  if (drawing_error.reason != Reason::none && drawing_error.reason != Reason::limit) return drawing_error;
  for (const Diagnostic& stopped : {derived->stopped, drawing_error, sketch.trouble()}) {
    if (stopped.reason == Reason::none) continue;
    plant.notes.push_back(message(messages::grammar::cut_short).encoded() + " " + stopped.message);
    plant.cut_short = cut_short_by(*limits.budget);
  }
  plant.notes.insert(plant.notes.end(), sketch.notes.begin(), sketch.notes.end());
  thicken(sketch.segments, {0.01f * values[thickness], values[thickening], 0.01f * values[widths]});

  // Traces by repeating the derivation, which may be cut short where the plant was not: then parts do not name modules.
  const auto traced = trace_derivation(*bound.value(), options.value(), limits, around);
  if (!traced) return traced.error();
  const std::optional<lsystem::DerivationTrace>& chronicle = traced.value();
  const bool whole = !chronicle || chronicle->counts().back() == lsystem::length(string);
  dress(plant, sketch,
        {.metres = metres,
         .sides = values.whole(sides),
         .meshes = options->meshes,
         .sky = options->sky,
         .marked = whole,
         .coarse = options->coarse,
         .budget = limits.budget});
  const auto count = [](std::uint64_t number) { return static_cast<std::uint32_t>(number); };
  plant.counts = {{"modules", count(lsystem::length(string))},
                  {"steps", derived->steps},
                  {"segments", count(plant.segments.size())},
                  {"organs", count(plant.organs.size())},
                  {"polygons", count(sketch.polygons.all.size())}};
  if (options->measures) measure(plant, {sketch, string, areas.value(), metres, limits.budget});
  add_area_columns(plant, sketch, area_memberships(*program.value(), string), areas.value());
  if (!whole) plant.notes.push_back(cut_short(*chronicle));
  if (chronicle) add_trace_columns(plant, *chronicle);
  if (options->string) {
    const bool too_long = string.used > max_words_as_text;
    plant.columns.add("string", too_long ? std::string() : lsystem::to_text(*program.value(), string));
    if (too_long) plant.notes.push_back(message(messages::grammar::string_too_long, string.modules));
  }
  if (plant.segments.empty() && plant.organs.empty())
    plant.notes.push_back(message(messages::lsystem_plant::nothing_drawn));
  for (const lsystem::Remark& remark : lsystem::remarks(*program.value(), options->inputs.scalars, options->steps))
    plant.notes.push_back(lsystem::to_text(remark));
  set_fingerprints(plant, options->mesh_fingerprint);
  return plant;
}

}  // namespace

extern const Model model;
const Model model{"grammar", grow, [](std::string_view text, const Limits& limits) {
                    return compile_program(text, program_options, limits);
                  }};

}  // namespace panicle::grammar
