// Helpers for tests of growth grammars: read and populate a text in one line.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "grammar_files.hpp"
#include "models/growth/population.hpp"
#include "sound.hpp"

namespace panicle::growth::tests {

using panicle::tests::content;
using panicle::tests::sound;

inline Rules rules_of(std::string_view text) { return sound(read_rules(text)); }

inline Population grown(const Rules& rules, std::uint16_t steps, std::uint64_t seed = 1) {
  std::vector<std::string> notes;
  return sound(populate(rules, seed, steps, Limits{}, notes));
}

inline Population grown(std::string_view text, std::uint16_t steps, std::uint64_t seed = 1) {
  return grown(rules_of(text), steps, seed);
}

// The error of reading and growing a text; none where it is valid.
inline Diagnostic trouble(std::string_view text, std::uint16_t steps = 6, const Limits& limits = {}) {
  const auto rules = read_rules(text, limits);
  if (!rules) return rules.error();
  std::vector<std::string> notes;
  if (const auto own = steps_of(rules.value(), 1, 6); !own) return own.error();
  const auto population = populate(rules.value(), 1, steps, limits, notes);
  return population ? Diagnostic{} : population.error();
}

inline std::vector<std::filesystem::path> files() { return panicle::tests::grammar_files("growth"); }

inline std::string text_named(const std::string& name) {
  return content(panicle::tests::repository_folder() + "/wasm-core/grammars/growth/" + name + ".growth");
}

}  // namespace panicle::growth::tests
