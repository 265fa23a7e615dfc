// Helpers of the tests of derivation traces.
#pragma once

#include "lsystem/grammars.hpp"
#include "lsystem/trace/derivation_trace.hpp"

namespace panicle::tests {

// Ignores all events and leaves queried parameters unchanged.
class Drawn : public Listener {
 public:
  void line(std::int32_t, const Turtle&, const Turtle&, const Lineage&) override {}
  void sphere(const Turtle&, float, const Lineage&) override {}
  void query(const Turtle&, std::span<float>, const Lineage&) override {}
  void cut(const Turtle&) override {}
};

inline lsystem::DerivationTrace traced(const BoundProgram& bound, std::optional<std::uint32_t> steps,
                                       const lsystem::TraceRequest& request,
                                       const lsystem::DerivationOptions& options = {}) {
  return sound(lsystem::trace_derivation(bound, 1, steps, Limits{}, options, request));
}

}  // namespace panicle::tests
