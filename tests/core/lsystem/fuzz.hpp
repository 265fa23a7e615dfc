// Compiles, derives and draws a text in every way: shared by the fuzz tests of this folder.
#pragma once

#include <algorithm>
#include <cmath>

#include "fuzz_dice.hpp"
#include "lsystem/derivation/derivation.hpp"
#include "lsystem/grammars.hpp"

namespace panicle::tests {

class Contrary : public Listener {
 public:
  void line(std::int32_t, const Turtle&, const Turtle&, const Lineage&) override { ++heard; }
  void sphere(const Turtle&, float, const Lineage&) override { ++heard; }
  void query(const Turtle&, std::span<float> parameters, const Lineage&) override {
    static const float replies[] = {0, 1, 0, -1, 0, 1 / 0.0f, 0, 0 / 0.0f, 3e38f};
    for (float& parameter : parameters) parameter = replies[heard++ % std::size(replies)];
  }
  void cut(const Turtle&) override { ++heard; }
  void polygon(const Turtle&, std::span<const glm::vec3> corners, const Lineage&) override {
    heard += 1 + static_cast<std::uint32_t>(corners.size());
  }
  void surface(const Turtle&, std::string_view name, float, const Lineage&) override { heard += !name.empty(); }
  std::uint32_t heard = 0;
};

// Slabs that are inside and outside in turn, and a reach that is no number at all in every fifth area.
class Slabs : public expression::Space {
 public:
  bool bound(const glm::vec3& place, float area) const override { return std::fmod(place.y + area, 2.0F) < 1; }
  float reach(const glm::vec3&, const glm::vec3&, float area, float most) const override {
    return area == 5 ? 0 / 0.0F : most / 2;
  }
};

inline Limits small_limits() {
  Limits limits;
  limits.steps = 30;
  limits.words = 20'000;
  limits.work = 20'000;
  limits.depth = 50;
  return limits;
}

// Alternates steps and queries. After every response the string must be well-formed.
inline Diagnostic derive_open(const BoundProgram& bound, Contrary& listener, const Limits& limits) {
  lsystem::Derivation derivation(bound, 1, limits);
  while (derivation.steps() < 12 && derivation.query_environment({}, listener)) {
    derivation.step();
    std::uint64_t modules = 0;
    std::int64_t open = 0;
    const lsystem::String& string = derivation.string();
    for (const std::uint32_t* at = string.begin(); at < string.end(); at += lsystem::words_of(*at)) {
      ++modules;
      open += lsystem::symbol_of(*at) == lsystem::push_symbol;
      open -= lsystem::symbol_of(*at) == lsystem::pop_symbol;
      CHECK(open >= 0);
    }
    CHECK(open == 0);
    CHECK(modules == lsystem::length(string));
  }
  Contrary unqueried;
  if (derivation.error().reason == Reason::none)
    lsystem::interpret_without_queries(bound, derivation.string(), {}, unqueried, 1, limits);
  return derivation.error();
}

inline bool draws_conditions(const lsystem::Program& program) {
  return std::any_of(program.productions.begin(), program.productions.end(),
                     [](const lsystem::Production& production) { return production.by_chance; });
}

// Returns 0 for a text that is derived and drawn; 1, 2 or 3 for the stage that failed. A diagnostic about the text must
// have a place in it.
inline int tried(const std::string& text, std::uint32_t mood) {
  const Inputs inputs{{{"m", 3}, {"x", 2}}, {{"n", {1, 2, 0}}}};
  const Limits limits = small_limits();
  const auto blamed = [&](const Diagnostic& diagnostic) {
    std::uint32_t lines = 1;
    for (const char c : text) lines += c == '\n';
    CHECK(diagnostic.reason != Reason::none);
    CHECK_FALSE(diagnostic.message.empty());
    CHECK(diagnostic.line <= lines);
    CHECK((diagnostic.line == 0) == (diagnostic.column == 0));
    CHECK(diagnostic.column <= text.size() + 1);
  };
  const auto notation = mood % 2 == 0 ? lsystem::Notation::cpfg : lsystem::Notation::huang;
  const auto program = lsystem::compile(text, limits, lsystem::Lineages::where_needed, notation);
  if (!program) return blamed(program.error()), 1;
  for (const lsystem::Remark& remark : lsystem::remarks(*program.value()))
    CHECK_FALSE(remark.message.encoded().empty());
  const auto bound = lsystem::bind(program.value(), inputs, limits);
  if (!bound) return blamed(bound.error()), 1;
  const Slabs space;
  const lsystem::DerivationOptions options{.start = {}, .space = &space};
  const auto so_far = lsystem::develop_so_far(*bound.value(), 1, 30, limits, options);
  const auto string = lsystem::develop(*bound.value(), 1, 30, limits);
  if (so_far && so_far->stopped.reason != Reason::none) CHECK(so_far->stopped.reason == Reason::limit);
  if (!string) {
    // The string that a limit ended can still be drawn.
    Contrary viewer;
    if (so_far) lsystem::interpret(*bound.value(), *so_far->string, {}, viewer, 1, limits, &space);
    return blamed(string.error()), 2;
  }
  const auto unfolded = lsystem::unfold(*bound.value(), 1, limits);
  if (!unfolded) blamed(unfolded.error());
  if (unfolded && !draws_conditions(*program.value()))
    CHECK(text_of(*bound.value(), unfolded.value()) == text_of(*bound.value(), string.value()));
  Contrary listener;
  listener.heard = mood;
  const Diagnostic opened = derive_open(*bound.value(), listener, limits);
  if (opened.reason != Reason::none) blamed(opened);
  const auto result = lsystem::interpret(*bound.value(), *string->string, {}, listener, 1, limits, &space);
  if (!result) return blamed(result.error()), 3;
  return 0;
}

}  // namespace panicle::tests
