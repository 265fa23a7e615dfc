// What the tests of chronicles share.
#pragma once

#include "lsystem/grammars.hpp"
#include "lsystem/trace/derivation_trace.hpp"

namespace panicle::tests {

// Hears nothing, and leaves what it is asked as it is.
class Drawn : public Listener {
 public:
  void line(std::int32_t, const Turtle&, const Turtle&, const Lineage&) override {}
  void sphere(const Turtle&, float, const Lineage&) override {}
  void ask(const Turtle&, std::span<float>, const Lineage&) override {}
  void cut(const Turtle&) override {}
};

inline lsystem::DerivationTrace told(const BoundProgram& bound, std::optional<std::uint32_t> steps,
                                     const lsystem::TraceRequest& asked, const lsystem::Surroundings& around = {}) {
  return sound(lsystem::chronicle(bound, 1, steps, Limits{}, around, asked));
}

}  // namespace panicle::tests
