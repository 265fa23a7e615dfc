// Helpers for tests of flowers: read and grow a text in one line.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "foundation/english.hpp"
#include "generalized_map/check.hpp"
#include "grammar_files.hpp"
#include "models/flower/derivation.hpp"
#include "sound.hpp"

namespace panicle::flower::tests {

using panicle::tests::content;
using panicle::tests::sound;

// A vein of three segments, a lobe on either side of each.
inline constexpr const char* leaf = R"(
#define V(4, 0, 0, 0, 4, 2, 2, 1)
#define R(4, 0, 0, 0, 5, 1, 4, 4)
#define S(4, 0, 0, 0, 5, 1, 4, 4)
#axiom: V
V{}{step < 2}{} -> V[V]_{E}
V -> V[R]_{C2, C4}
R -> R[S]_{E}
R : R_C1 < R_C3 -> R_C1 | R_C3
S : S_C1 < S_C3 -> S_C1 | S_C3
#define finalStep=6
)";

inline Program program_of(std::string_view text) { return sound(read_program(text)); }

inline Given steps(std::uint32_t steps, std::uint64_t seed = 1) {
  Given given;
  given.steps = steps;
  given.seed = seed;
  return given;
}

struct Flower {
  Program program;
  Derived derived;

  // How many volumes have a label now.
  std::size_t count(std::string_view label) const {
    std::size_t found = 0;
    for (std::uint32_t v = 0; v < derived.map.volumes(); ++v) found += name(v) == label;
    return found;
  }
  const std::string& name(std::uint32_t volume) const { return program.labels[derived.map.volume(volume).label].name; }
  float value(std::uint32_t volume, Field field) const {
    return derived.values[derived.record_of[volume]][static_cast<std::size_t>(field)];
  }
  bool noted(std::string_view words) const {
    return std::any_of(derived.notes.begin(), derived.notes.end(),
                       [&](const std::string& note) { return english(note).find(words) != std::string::npos; });
  }
};

inline Flower grown(std::string_view text, const Given& given = {}, const Limits& limits = {}) {
  Program program = program_of(text);
  Derived derived = sound(derive(program, given, limits));
  return {std::move(program), std::move(derived)};
}

// The error of reading and growing a text; none where it is valid.
inline Diagnostic trouble(std::string_view text, const Given& given = {}, const Limits& limits = {}) {
  const auto program = read_program(text, limits);
  if (!program) return program.error();
  const auto derived = derive(program.value(), given, limits);
  return derived ? Diagnostic{} : derived.error();
}

inline std::vector<std::filesystem::path> files() { return panicle::tests::grammar_files("flower"); }

inline std::string text_named(const std::string& name) {
  return content(panicle::tests::repository_folder() + "/wasm-core/grammars/flower/" + name + ".gl3");
}

}  // namespace panicle::flower::tests
