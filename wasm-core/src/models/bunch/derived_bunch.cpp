#include "models/bunch/derived_bunch.hpp"

#include <utility>

#include "foundation/random.hpp"
#include "models/bunch/messages.generated.hpp"

namespace panicle::bunch {

// The L-system to use: the compiled one of the request, its text, or the `built_in` text.
Result<std::shared_ptr<const lsystem::Program>> program_for(const BunchRequest& request, std::string_view built_in,
                                                            const Limits& limits) {
  if (request.program) return request.program;
  if (request.grammar.empty() && built_in.empty()) return bad_request(message(messages::bunch::no_grammar));
  return lsystem::compile(request.grammar.empty() ? built_in : request.grammar, limits, lsystem::Lineages::always);
}

// Rewrites the axiom of the L-system up to its last step, or for `steps` steps.
Result<DerivedBunch> derive_bunch(std::shared_ptr<const lsystem::BoundProgram> bound, std::uint64_t seed,
                                  std::optional<std::uint32_t> steps, const Limits& limits) {
  auto derived = lsystem::develop(*bound, seed, steps, limits);
  if (!derived) return derived.error();
  return DerivedBunch{std::move(bound), std::move(derived->string), seed, 0, {}};
}

// The seed of the second bunch.
std::uint64_t second_seed(std::uint64_t seed) { return hash_combine(seed, hash_text("second bunch")); }

// Records how each module came into the string, if the request wants a trace.
Result<std::optional<lsystem::DerivationTrace>> trace_derivation(const DerivedBunch& derived_bunch,
                                                                 const BunchRequest& request, const Limits& limits) {
  if (!request.trace) return std::optional<lsystem::DerivationTrace>();
  auto trace =
      lsystem::trace_derivation(*derived_bunch.bound, derived_bunch.seed, request.steps, limits, {}, *request.trace);
  if (!trace) return trace.error();
  // After a limit the traced string differs from the drawn one.
  if (trace->stopped().reason == Reason::none) trace->watch_drawing(derived_bunch.string);
  return std::optional(std::move(trace.value()));
}

// Draws the derived string with a turtle (a moving pen) that starts in the bunch's stance; `listener` receives the
// parts.
Diagnostic interpret(const DerivedBunch& derived_bunch, const Limits& limits, lsystem::Listener& listener,
                     lsystem::DerivationTrace* trace) {
  lsystem::Turtle turtle;
  const auto& [lean, side, foot] = derived_bunch.stance;
  turtle.position = foot;
  if (side < 2)
    lsystem::turn(turtle, side == 0 ? lean : -lean);
  else
    lsystem::pitch(turtle, side == 2 ? -lean : lean);
  const auto drawn = lsystem::interpret(*derived_bunch.bound, *derived_bunch.string, turtle, listener,
                                        derived_bunch.seed, limits, nullptr, trace);
  return drawn ? Diagnostic{} : drawn.error();
}

}  // namespace panicle::bunch
