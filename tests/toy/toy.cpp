// The toy's core: any grammar, drawn as it stands, upright. With toy.json (its table) and index.ts it is a whole model.
#include "lsystem_plant/plain_plant.hpp"
#include "lsystem_plant/requested_program.hpp"
#include "protocol/common_request.hpp"
#include "protocol/model.hpp"

namespace panicle::toy {
namespace {

Result<Plant> grow(Request& request, const Limits& limits) {
  PlainOptions options;
  const CommonRequest common = read_common(request);
  options.seed = common.seed;
  options.meshes = common.meshes;
  options.sky = common.sky;
  options.mesh_fingerprint = common.mesh_fingerprint;
  if (request.has("steps")) options.steps = request.word("steps");
  const auto program = requested_program(request, {}, limits);
  if (Diagnostic error = request.trouble(); error.reason != Reason::none) return error;
  if (!program) return program.error();
  lsystem::turn(options.turtle, 180);
  lsystem::Inputs inputs;
  if (!common.parameters.empty()) inputs.scalars.push_back({"height", common.parameters[0]});
  if (common.parameters.size() > 1) inputs.scalars.push_back({"spread", common.parameters[1]});
  return draw_plainly(program.value(), inputs, options, limits);
}

}  // namespace

extern const Model model;
const Model model{"toy", grow,
                  [](std::string_view text, const Limits& limits) { return compile_program(text, {}, limits); }};

}  // namespace panicle::toy
