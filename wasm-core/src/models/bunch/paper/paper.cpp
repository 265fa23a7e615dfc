#include "models/bunch/paper/paper.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "foundation/mathematics.hpp"
#include "models/bunch/berry_ids.hpp"
#include "models/bunch/derived_bunch.hpp"
#include "models/bunch/grammars.hpp"
#include "models/bunch/measures/measures.hpp"
#include "models/bunch/messages.generated.hpp"
#include "models/bunch/paper/growth.hpp"
#include "models/bunch/remarks.hpp"
#include "models/bunch/shape.hpp"
#include "models/bunch/units.hpp"

namespace panicle::bunch {

// The rachis is the main axis of the bunch.

namespace {

// The plan: one bunch, or two on one peduncle.
struct Planned {
  DerivedBunch first;
  std::optional<DerivedBunch> second;
};

// Binds the L-system to the inputs of a shape, and derives its string.
Result<DerivedBunch> derived_bunch_for(const Shape& shape, const Values& values,
                                       std::shared_ptr<const lsystem::Program> program, std::uint64_t seed,
                                       std::optional<std::uint32_t> steps, const Limits& limits) {
  auto bound = lsystem::bind(std::move(program), inputs_for(shape, values), limits);
  if (!bound) return bound.error();
  return derive_bunch(std::move(bound.value()), seed, steps, limits);
}

// Plans and derives the bunch of the paper, and a second, smaller one if `wing` is above 0.
Result<Planned> plan_bunches(const BunchRequest& request, const Values& values, const Limits& limits,
                             GrownBunch& grown) {
  using enum Parameter;
  const Profile profile = values.profile();
  auto shape = shape_for(request, profile, values[fit]);
  if (!shape) return shape.error();
  auto program = program_for(request, grammars::grape_bunch_3, limits);
  if (!program) return program.error();
  auto first = derived_bunch_for(shape.value(), values, program.value(), request.seed, request.steps, limits);
  if (!first) return first.error();
  grown.plan = std::move(shape->plan);
  Planned planned{std::move(first.value()), std::nullopt};
  if (!(values[wing] > 0)) return planned;

  Shape smaller = shape_of(scaled(profile, values[wing]), values[fit]);
  auto second = derived_bunch_for(smaller, values, program.value(), second_seed(request.seed), request.steps, limits);
  if (!second) return second.error();
  second->first_axis = grown.plan.m - 1;
  second->stance.lean = values[wing_angle];
  grown.second = std::move(smaller.plan);
  planned.second = std::move(second.value());
  return planned;
}

// Interprets a bunch into the growth, among the structure that is there already.
Diagnostic grow_bunch(const DerivedBunch& derived_bunch, const SymbolRoles& roles, const Limits& limits,
                      PaperGrowth& growth, bool second, lsystem::DerivationTrace* trace = nullptr) {
  growth.begin(*derived_bunch.bound, roles, second, derived_bunch.seed, derived_bunch.first_axis);
  const Diagnostic error = interpret(derived_bunch, limits, growth, trace);
  return error.reason == Reason::none ? growth.trouble() : error;
}

// Grows both bunches. The second bunch's rachis is placed first, for it would find no way through the first's berries;
// the berries of both come later, as in nature. `second_from` becomes the number of the second's first berry.
Diagnostic grow_bunches(const Planned& planned, const SymbolRoles& roles, const Limits& limits, PaperGrowth& growth,
                        lsystem::DerivationTrace* trace, std::size_t& second_from) {
  Diagnostic error;
  if (planned.second) {
    growth.begin_rachis_pass();
    error = grow_bunch(*planned.second, roles, limits, growth, true);
    growth.end_rachis_pass();
  }
  growth.set_trace(trace);
  if (error.reason == Reason::none) error = grow_bunch(planned.first, roles, limits, growth, false, trace);
  second_from = growth.attached_balls();
  if (error.reason == Reason::none && planned.second) error = grow_bunch(*planned.second, roles, limits, growth, true);
  return error;
}

// The internodes scaled by `metres`, the size of their unit.
std::vector<Internode> in_metres(std::vector<Internode> internodes, float metres) {
  for (Internode& internode : internodes) scale(internode, metres);
  return internodes;
}

// Makes the berries of balls, scaled from the grammar's unit to metres. Balls from `second_from` on are of the second
// bunch, whose modules are not traced.
std::vector<Berry> berries_of(std::span<const Ball> balls, std::size_t second_from, float scale) {
  std::vector<std::uint64_t> addresses;
  for (const Ball& ball : balls) addresses.push_back(ball.address);
  const std::vector<std::uint32_t> ids = berry_ids(own_addresses(addresses), second_from);
  std::vector<Berry> berries;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Ball& ball = balls[i];
    berries.push_back({ball.centre * scale, ball.radius * scale, ball.heading, ball.segment, ids[i],
                       i < second_from ? ball.module : no_module});
  }
  return berries;
}

// The sideways reach of an end structure, in the paper's units: its twig, its pedicel and a berry, by the rates of the
// text (L-system 3's names), or of the table where it has none.
float end_reach(const lsystem::BoundProgram& text, const Values& values) {
  const auto rate = [&](Parameter key) {
    return lsystem::constant(text, parameter_table[static_cast<std::size_t>(key)].define, values[key]);
  };
  using enum Parameter;
  const float stalk = rate(li) * rate(rrf) * rate(re) * (1 + rate(rp)) * sincos_degrees(rate(yaw)).sine;
  return std::abs(stalk) + rate(rmin) + rate(rmax);
}

// The outlines of one or both bunches, with their stances; millimetres.
std::vector<HungEnvelope> envelopes_of(const Planned& planned, const Values& values) {
  using enum Parameter;
  const Profile profile = values.profile();
  const float pixel = values[unit] * units_per_pixel, reach = end_reach(*planned.first.bound, values) * values[unit];
  std::vector<HungEnvelope> envelopes{{Envelope(profile, pixel, reach), {}}};
  if (planned.second)
    envelopes.push_back({Envelope(scaled(profile, values[wing]), pixel, reach), planned.second->stance});
  return envelopes;
}

}  // namespace

// Grows a bunch as in the paper: plan, derivation, drawing among the spheres of earlier parts, notes and measures.
Diagnostic grow_paper(const BunchRequest& request, const Values& values, const Limits& limits, GrownBunch& grown) {
  using enum Parameter;
  const auto planned = plan_bunches(request, values, limits, grown);
  if (!planned) return planned.error();
  const lsystem::BoundProgram& text = *planned->first.bound;
  const SymbolRoles roles = roles_of(lsystem::program_of(text), grown.notes);

  const InteractionOptions interaction{values[delta], static_cast<std::uint32_t>(values[t]), values[sag]};
  PaperGrowth growth(interaction, limits, std::max(values[rmin], values[rmax]));
  auto traced = trace_derivation(planned->first, request, limits);
  if (!traced) return traced.error();
  grown.trace = std::move(traced.value());
  lsystem::DerivationTrace* const trace = grown.trace ? &*grown.trace : nullptr;
  std::size_t second_from = 0;
  Diagnostic error = grow_bunches(planned.value(), roles, limits, growth, trace, second_from);
  if (error.reason != Reason::none) return error;
  const std::uint32_t loose = growth.finish();

  remark_text(text, values, "paper", {}, grown.notes);
  remark_drawn({growth.internodes.size(), growth.balls.size(), loose, growth.refused()}, grown.notes);
  if (growth.rachis_cut) grown.notes.push_back(message(messages::bunch::rachis_ends_early));
  const float scale = values[unit] * metres_per_millimetre;
  grown.berries = berries_of(growth.balls, second_from, scale);
  grown.internodes = in_metres(std::move(growth.internodes), scale);
  grown.counts.cut = growth.cuts;
  for (const Berry& berry : grown.berries) grown.traits.push_back({2 * berry.radius, 2 * berry.radius});
  if (request.measures) grown.measures = measure(grown, envelopes_of(planned.value(), values));
  return {};
}

}  // namespace panicle::bunch
