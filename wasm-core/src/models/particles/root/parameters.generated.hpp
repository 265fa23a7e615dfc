// Made from wasm-core/parameters/root.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace panicle::particles::root {

// In the order of the request's words.
enum class Parameter : std::uint32_t {
  shape,
  width,
  reach,
  depth,
  inner,
  top,
  stems,
  slant,
  gravitropism,
  sway,
  crook,
  law,
  exponent,
  girth,
  twig,
  storage,
  storage_reach,
  stump,
  particles,
  pattern,
  topsoil,
  step,
  merge,
  neighbourhood,
  energy,
  pull,
  rule,
  age,
  life,
  hormone,
};

inline constexpr std::uint32_t parameter_count = 30;

struct ParameterInfo {
  std::string_view key;
  std::string_view define;  // the grammar's #define it replaces; empty for none
  std::string_view where;   // the option that must be chosen for it to be heeded; empty: always
  float min, max;
  float gap_below;  // values strictly between 0 and this are raised to it; 0 for none
  float standard;
  bool whole;
};

// clang-format off
inline constexpr std::array<ParameterInfo, parameter_count> parameter_table = {{
    {"shape", "", "", 0.0f, 5.0f, 0.0f, 1.0f, true},
    {"width", "", "", 0.02f, 60.0f, 0.0f, 2.0f, false},
    {"reach", "", "", 0.02f, 30.0f, 0.0f, 1.2f, false},
    {"depth", "", "", 0.02f, 60.0f, 0.0f, 2.0f, false},
    {"inner", "", "", 0.0f, 0.95f, 0.0f, 0.0f, false},
    {"top", "", "", 0.0f, 5.0f, 0.0f, 0.0f, false},
    {"stems", "", "", 1.0f, 60.0f, 0.0f, 1.0f, true},
    {"slant", "", "", 0.0f, 8.0f, 0.0f, 1.0f, false},
    {"gravitropism", "", "", -1.0f, 1.0f, 0.0f, 0.0f, false},
    {"sway", "", "", 0.0f, 0.5f, 0.0f, 0.06f, false},
    {"crook", "", "", 0.0f, 1.0f, 0.0f, 0.15f, false},
    {"law", "", "", 0.0f, 3.0f, 0.0f, 1.0f, true},
    {"exponent", "", "power", 0.1f, 1.5f, 0.0f, 0.45f, false},
    {"girth", "", "", 0.2f, 500.0f, 0.0f, 8.0f, false},
    {"twig", "", "", 0.1f, 50.0f, 0.0f, 0.6f, false},
    {"storage", "", "", 0.0f, 100.0f, 0.0f, 0.0f, false},
    {"storage_reach", "", "", 0.05f, 1.0f, 0.0f, 0.6f, false},
    {"stump", "", "", 0.0f, 200.0f, 0.0f, 4.0f, false},
    {"particles", "", "", 10.0f, 100000.0f, 0.0f, 3000.0f, true},
    {"pattern", "", "", 0.0f, 3.0f, 0.0f, 2.0f, true},
    {"topsoil", "", "topsoil", 0.02f, 10.0f, 0.0f, 0.4f, false},
    {"step", "", "", 0.05f, 2.0f, 0.0f, 0.35f, false},
    {"merge", "", "", 0.1f, 4.0f, 0.0f, 0.7f, false},
    {"neighbourhood", "", "", 0.0f, 100.0f, 0.0f, 0.0f, false},
    {"energy", "", "", 0.01f, 100.0f, 0.0f, 1.0f, false},
    {"pull", "", "", 0.0f, 4.0f, 0.0f, 1.0f, false},
    {"rule", "", "", 0.0f, 1.0f, 0.0f, 0.0f, true},
    {"age", "", "", 0.0f, 100.0f, 0.0f, 100.0f, false},
    {"life", "", "", 0.0f, 1.0f, 0.0f, 0.0f, true},
    {"hormone", "", "", 0.0f, 1.0f, 0.0f, 0.0f, false},
}};
// clang-format on

}  // namespace panicle::particles::root
