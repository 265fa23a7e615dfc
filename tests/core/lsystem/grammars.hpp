// Helpers of the tests of the L-system engine: one-line ways to compile, derive and record events.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "foundation/english.hpp"
#include "lsystem/lsystem.hpp"
#include "sound.hpp"

namespace panicle::tests {

using lsystem::BoundProgram;
using lsystem::Derived;
using lsystem::Inputs;
using lsystem::Lineage;
using lsystem::Listener;
using lsystem::Turtle;

using BoundPointer = std::shared_ptr<const BoundProgram>;

inline BoundPointer compiled(std::string_view text, const Inputs& inputs = {},
                             lsystem::Lineages lineages = lsystem::Lineages::where_needed) {
  return sound(lsystem::bind(sound(lsystem::compile(text, Limits{}, lineages)), inputs, Limits{}));
}

inline std::string text_of(const BoundProgram& bound, const Derived& derived) {
  return lsystem::to_text(lsystem::program_of(bound), *derived.string);
}

inline Derived derived(const BoundProgram& bound, std::uint32_t steps, std::uint64_t seed = 1) {
  return sound(lsystem::develop(bound, seed, steps, Limits{}));
}

// The string after so many steps, as text.
inline std::string after(std::string_view text, std::uint32_t steps, const Inputs& inputs = {},
                         std::uint64_t seed = 1) {
  const BoundPointer bound = compiled(text, inputs);
  return text_of(*bound, derived(*bound, steps, seed));
}

// The first error of a text that is compiled, bound and derived, step by step and to its end, as "reason line:column";
// "none" without an error.
inline std::string trouble(std::string_view text, const Inputs& inputs = {}, const Limits& limits = {},
                           std::string* message = nullptr) {
  static const char* const reasons[] = {"none",      "bad_request", "bad_input", "syntax",
                                        "undefined", "evaluation",  "limit"};
  const Diagnostic diagnostic = [&] {
    const auto program = lsystem::compile(text, limits);
    if (!program) return program.error();
    const auto bound = lsystem::bind(program.value(), inputs, limits);
    if (!bound) return bound.error();
    const auto steps = lsystem::develop(*bound.value(), 1, limits.steps, limits);
    if (!steps) return steps.error();
    const auto whole = lsystem::unfold(*bound.value(), 1, limits);
    return whole ? Diagnostic{} : whole.error();
  }();
  if (message) *message = english(diagnostic.message);
  if (diagnostic.reason == Reason::none) return "none";
  return std::string(reasons[static_cast<std::uint32_t>(diagnostic.reason)]) + " " + std::to_string(diagnostic.line) +
         ":" + std::to_string(diagnostic.column);
}

// Records all events, and responds to queries with given parameters.
class Recorder : public Listener {
 public:
  struct Line {
    Turtle before, after;
    std::string parent, grandparent;
    std::uint64_t address = 0;
  };
  struct Ball {
    Turtle turtle;
    float radius = 0;
  };

  void line(std::int32_t id, const Turtle& before, const Turtle& after, const Lineage& lineage) override {
    CHECK(id == static_cast<std::int32_t>(lines.size()));
    CHECK(after.line == id);
    lines.push_back({before, after, std::string(lineage.parent), std::string(lineage.grandparent), lineage.address});
  }
  void sphere(const Turtle& turtle, float radius, const Lineage&) override { spheres.push_back({turtle, radius}); }
  void query(const Turtle&, std::span<float> parameters, const Lineage& lineage) override {
    queried.emplace_back(parameters.begin(), parameters.end());
    queried_by.emplace_back(lineage.parent);
    addresses.push_back(lineage.address);
    if (answers.empty()) return;
    const std::vector<float>& answer = answers[(queried.size() - 1) % answers.size()];
    for (std::size_t i = 0; i < answer.size() && i < parameters.size(); ++i) parameters[i] = answer[i];
  }
  void cut(const Turtle&) override { ++cuts; }

  std::vector<std::vector<float>> answers;  // in turn, over and over; none: leave the parameters as they are
  std::vector<std::vector<float>> queried;
  std::vector<std::string> queried_by;
  std::vector<std::uint64_t> addresses;
  std::vector<Line> lines;
  std::vector<Ball> spheres;
  int cuts = 0;
};

inline void draw(const BoundProgram& bound, const Derived& string, Recorder& recorder, std::uint64_t seed = 1) {
  const auto drawn = lsystem::interpret(bound, *string.string, {}, recorder, seed, Limits{});
  if (!drawn) FAIL(english(drawn.error().message));
  CHECK(drawn.value() == recorder.lines.size());
}

inline Recorder drawn(std::string_view text, std::uint32_t steps, const Inputs& inputs = {}) {
  const BoundPointer bound = compiled(text, inputs);
  Recorder recorder;
  draw(*bound, derived(*bound, steps), recorder);
  return recorder;
}

}  // namespace panicle::tests
