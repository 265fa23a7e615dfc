// Made from wasm-core/parameters/leaf.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace panicle::particles::leaf {

// In the order of the request's words.
enum class Parameter : std::uint32_t {
  length,
  teeth,
  tooth_depth,
  tooth_shape,
  entire,
  petiole,
  petiole_width,
  ribs,
  secondaries,
  angle,
  spacing,
  offset,
  arch,
  course,
  slant,
  law,
  exponent,
  vein,
  smoothing,
  thickness,
  relief,
  curl,
  fold,
  undulation,
  waves,
  age,
  particles,
  pattern,
  step,
  merge,
  neighbourhood,
  energy,
  pull,
  rule,
  join,
};

inline constexpr std::uint32_t parameter_count = 35;

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
    {"length", "", "", 5.0f, 600.0f, 0.0f, 90.0f, false},
    {"teeth", "", "", 0.0f, 80.0f, 0.0f, 0.0f, true},
    {"tooth_depth", "", "", 5.0f, 100.0f, 0.0f, 35.0f, false},
    {"tooth_shape", "", "", 0.0f, 4.0f, 0.0f, 1.0f, true},
    {"entire", "", "", 0.0f, 90.0f, 0.0f, 0.0f, false},
    {"petiole", "", "", 0.0f, 250.0f, 0.0f, 30.0f, false},
    {"petiole_width", "", "", 0.1f, 20.0f, 0.0f, 1.6f, false},
    {"ribs", "", "", 0.0f, 3.0f, 0.0f, 1.0f, true},
    {"secondaries", "", "", 0.0f, 40.0f, 0.0f, 8.0f, true},
    {"angle", "", "", 15.0f, 90.0f, 0.0f, 50.0f, false},
    {"spacing", "", "", 0.3f, 3.0f, 0.0f, 0.8f, false},
    {"offset", "", "", 0.0f, 1.0f, 0.0f, 0.4f, false},
    {"arch", "", "", 0.0f, 1.0f, 0.0f, 0.4f, false},
    {"course", "", "", 0.0f, 2.0f, 0.0f, 0.0f, true},
    {"slant", "", "", 0.0f, 3.0f, 0.0f, 0.8f, false},
    {"law", "", "", 0.0f, 2.0f, 0.0f, 1.0f, true},
    {"exponent", "", "power", 0.1f, 1.5f, 0.0f, 0.33f, false},
    {"vein", "", "", 0.05f, 10.0f, 0.0f, 1.4f, false},
    {"smoothing", "", "", 0.0f, 1.0f, 0.0f, 1.0f, false},
    {"thickness", "", "", 0.05f, 3.0f, 0.0f, 0.25f, false},
    {"relief", "", "", 0.0f, 3.0f, 0.0f, 1.0f, false},
    {"curl", "", "", -180.0f, 270.0f, 0.0f, 35.0f, false},
    {"fold", "", "", -80.0f, 85.0f, 0.0f, 14.0f, false},
    {"undulation", "", "", 0.0f, 30.0f, 0.0f, 4.0f, false},
    {"waves", "", "", 0.5f, 20.0f, 0.0f, 4.0f, false},
    {"age", "", "", 0.0f, 100.0f, 0.0f, 100.0f, false},
    {"particles", "", "", 1.0f, 20000.0f, 0.0f, 2000.0f, true},
    {"pattern", "", "", 0.0f, 2.0f, 0.0f, 2.0f, true},
    {"step", "", "", 0.05f, 2.0f, 0.0f, 0.35f, false},
    {"merge", "", "", 0.0f, 3.0f, 0.0f, 0.7f, false},
    {"neighbourhood", "", "", 0.0f, 50.0f, 0.0f, 0.0f, false},
    {"energy", "", "", 0.01f, 100.0f, 0.0f, 1.0f, false},
    {"pull", "", "", 0.0f, 4.0f, 0.0f, 0.75f, false},
    {"rule", "", "", 0.0f, 1.0f, 0.0f, 0.0f, true},
    {"join", "", "", 0.0f, 2.0f, 0.0f, 0.25f, false},
}};
// clang-format on

}  // namespace panicle::particles::leaf
