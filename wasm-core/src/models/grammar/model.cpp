#include "models/grammar/model.hpp"

#include <optional>
#include <string>
#include <utility>

#include "models/grammar/dressing.hpp"
#include "models/grammar/girth.hpp"
#include "models/grammar/parameters.generated.hpp"
#include "models/grammar/sketch.hpp"
#include "plant/plain.hpp"
#include "plant/values.hpp"

namespace panicle::grammar {
namespace {

using GrammarValues = Values<Parameter, parameter_table>;
using enum Parameter;

constexpr float metres_a_millimetre = 0.001f;

// What is asked for.
struct Asked {
  std::uint64_t seed = 1;
  std::optional<std::uint32_t> steps;
  std::span<const float> parameters;
  lsystem::Inputs inputs;
  bool meshes = true, sky = false, mesh_fingerprint = false, string = false;
};

// A name a line, and as many values.
Diagnostic read_constants(Request& request, lsystem::Inputs& inputs) {
  std::string_view names = request.text("constants.names");
  for (const float value : request.floats("constants.values")) {
    const std::size_t end = names.find('\n');
    if (names.empty()) return {Reason::bad_request, "The request has more constants than names.", 0, 0};
    inputs.scalars.push_back({std::string(names.substr(0, end)), value});
    names = end == std::string_view::npos ? std::string_view() : names.substr(end + 1);
  }
  if (!names.empty()) return {Reason::bad_request, "The request has more names than constants.", 0, 0};
  return {};
}

Result<Asked> read(Request& request) {
  Asked asked;
  request.text("model");
  asked.seed = request.word("seed", 1);
  asked.meshes = request.wants("meshes");
  asked.sky = request.wants("sky");
  asked.mesh_fingerprint = request.wants("mesh_fingerprint");
  asked.string = request.wants("string");
  if (request.has("steps")) asked.steps = request.word("steps");
  asked.parameters = request.floats("parameters");
  if (Diagnostic trouble = read_constants(request, asked.inputs); trouble.reason != Reason::none) return trouble;
  return asked;
}

// Upright, its left side to the left of who looks from +Z.
lsystem::Turtle standing() {
  lsystem::Turtle turtle;
  turtle.heading = {0, 1, 0};
  turtle.left = {-1, 0, 0};
  turtle.up = {0, 0, 1};
  turtle.width = no_width;
  return turtle;
}

// Of a plant that is nothing but what its text draws there may be as many lines as of particles' ways, and as many
// balls as of what trees bear.
Limits roomy(Limits limits) {
  limits.segments = limits.pieces;
  limits.spheres = limits.copies;
  return limits;
}

Result<Plant> grow(Request& request, const Limits& given) {
  const Limits limits = roomy(given);
  const Result<Asked> asked = read(request);
  const auto program = request.program(limits);
  if (Diagnostic trouble = request.trouble(); trouble.reason != Reason::none) return trouble;
  if (!asked) return asked.error();
  if (!program) return program.error();
  Plant plant;
  const GrammarValues values(asked->parameters, plant.notes);

  const auto bound = lsystem::bind(program.value(), asked->inputs, limits);
  if (!bound) return bound.error();
  const auto derived = lsystem::develop_so_far(*bound.value(), asked->seed, asked->steps, limits, {standing()});
  if (!derived) return derived.error();
  const lsystem::String& string = *derived->string;
  Sketch sketch(limits);
  sketch.begin();
  const auto drawn = lsystem::interpret(*bound.value(), string, standing(), sketch, asked->seed, limits);
  if (!drawn) return drawn.error();
  for (const Diagnostic& stopped : {derived->stopped, sketch.trouble()})
    if (stopped.reason != Reason::none) plant.notes.push_back("What grew so far is shown. " + stopped.message);
  plant.notes.insert(plant.notes.end(), sketch.notes.begin(), sketch.notes.end());
  thicken(sketch.segments, {0.01f * values[thickness], values[thickening], 0.01f * values[widths]});

  dress(plant, sketch,
        {.metres = metres_a_millimetre * values[unit],
         .sides = values.whole(sides),
         .meshes = asked->meshes,
         .sky = asked->sky});
  const auto count = [](std::uint64_t number) { return static_cast<std::uint32_t>(number); };
  plant.counts = {{"modules", count(lsystem::length(string))},
                  {"steps", derived->steps},
                  {"segments", count(plant.segments.size())},
                  {"organs", count(plant.organs.size())},
                  {"polygons", count(sketch.polygons.all.size())}};
  if (asked->string) plant.columns.add("string", lsystem::to_text(*program.value(), string));
  if (plant.segments.empty() && plant.organs.empty()) plant.notes.push_back("The grammar draws nothing.");
  for (const lsystem::Remark& remark : lsystem::remarks(*program.value(), asked->inputs.scalars, asked->steps))
    plant.notes.push_back(lsystem::to_text(remark));
  plant.fingerprint = fingerprint_of(plant);
  if (asked->meshes && asked->mesh_fingerprint) plant.mesh_fingerprint = mesh_fingerprint_of(plant);
  return plant;
}

}  // namespace

extern const Model model;
const Model model{"grammar", grow, lsystem::Notation::cpfg, lsystem::Lineages::where_needed};

}  // namespace panicle::grammar
