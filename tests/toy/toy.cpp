// The toy's core: any grammar, drawn as it stands, upright. With toy.json (its table) and index.ts it is a whole model.
#include "lsystem_plant/plain_plant.hpp"
#include "lsystem_plant/requested_program.hpp"
#include "protocol/model.hpp"

namespace panicle::toy {
namespace {

Result<Plant> grow(Request& request, const Limits& limits) {
  PlainOptions options;
  request.text("model");
  options.seed = request.word("seed", 1);
  options.meshes = request.wants("meshes");
  options.sky = request.wants("sky");
  options.mesh_fingerprint = request.wants("mesh_fingerprint");
  if (request.has("steps")) options.steps = request.word("steps");
  const auto parameters = request.floats("parameters");
  const auto program = requested_program(request, {}, limits);
  if (Diagnostic trouble = request.trouble(); trouble.reason != Reason::none) return trouble;
  if (!program) return program.error();
  lsystem::turn(options.turtle, 180);
  lsystem::Inputs inputs;
  if (!parameters.empty()) inputs.scalars.push_back({"height", parameters[0]});
  if (parameters.size() > 1) inputs.scalars.push_back({"spread", parameters[1]});
  return draw_plainly(program.value(), inputs, options, limits);
}

}  // namespace

extern const Model model;
const Model model{"toy", grow,
                  [](std::string_view text, const Limits& limits) { return compile_program(text, {}, limits); }};

}  // namespace panicle::toy
