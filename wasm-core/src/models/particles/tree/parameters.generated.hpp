// Made from wasm-core/parameters/tree.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace panicle::particles::tree {

// In the order of the request's words.
enum class Parameter : std::uint32_t {
  shape,
  width,
  height,
  depth,
  inner,
  ragged,
  trunk,
  crowns,
  distance,
  stems,
  sun,
  sun_height,
  sky,
  absorption,
  by_light,
  slant,
  phototropism,
  gravitropism,
  weep,
  weep_tips,
  sway,
  crook,
  law,
  exponent,
  girth,
  flare,
  twig,
  leaves,
  leaf_size,
  leaf_kind,
  leaf_breadth,
  leaf_fold,
  particles,
  pattern,
  step,
  merge,
  neighbourhood,
  energy,
  pull,
  rule,
  age,
  life,
  day,
  hormone,
};

inline constexpr std::uint32_t parameter_count = 44;

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
    {"width", "", "", 0.1f, 60.0f, 0.0f, 6.0f, false},
    {"height", "", "", 0.1f, 60.0f, 0.0f, 6.0f, false},
    {"depth", "", "", 0.1f, 60.0f, 0.0f, 6.0f, false},
    {"inner", "", "", 0.0f, 0.95f, 0.0f, 0.75f, false},
    {"ragged", "", "", 0.0f, 0.6f, 0.0f, 0.0f, false},
    {"trunk", "", "", 0.0f, 30.0f, 0.0f, 2.0f, false},
    {"crowns", "", "", 1.0f, 12.0f, 0.0f, 1.0f, true},
    {"distance", "", "", 0.0f, 60.0f, 0.0f, 6.0f, false},
    {"stems", "", "", 1.0f, 60.0f, 0.0f, 1.0f, true},
    {"sun", "", "", 0.0f, 360.0f, 0.0f, 40.0f, false},
    {"sun_height", "", "", 0.0f, 90.0f, 0.0f, 45.0f, false},
    {"sky", "", "", 0.0f, 1.0f, 0.0f, 0.6f, false},
    {"absorption", "", "", 0.0f, 20.0f, 0.0f, 4.0f, false},
    {"by_light", "", "light", 0.0f, 2.0f, 0.0f, 1.0f, false},
    {"slant", "", "", 0.0f, 4.0f, 0.0f, 1.0f, false},
    {"phototropism", "", "", -1.0f, 1.0f, 0.0f, 0.0f, false},
    {"gravitropism", "", "", -1.0f, 1.0f, 0.0f, 0.0f, false},
    {"weep", "", "", 0.0f, 1.0f, 0.0f, 0.0f, false},
    {"weep_tips", "", "", 2.0f, 500.0f, 0.0f, 20.0f, true},
    {"sway", "", "", 0.0f, 0.5f, 0.0f, 0.04f, false},
    {"crook", "", "", 0.0f, 1.0f, 0.0f, 0.0f, false},
    {"law", "", "", 0.0f, 3.0f, 0.0f, 1.0f, true},
    {"exponent", "", "power", 0.1f, 1.5f, 0.0f, 0.45f, false},
    {"girth", "", "", 0.2f, 500.0f, 0.0f, 30.0f, false},
    {"flare", "", "", 0.0f, 3.0f, 0.0f, 0.5f, false},
    {"twig", "", "", 0.1f, 50.0f, 0.0f, 4.0f, false},
    {"leaves", "", "", 0.0f, 6.0f, 0.0f, 2.0f, true},
    {"leaf_size", "", "", 0.2f, 60.0f, 0.0f, 14.0f, false},
    {"leaf_kind", "", "", 0.0f, 6.0f, 0.0f, 3.0f, true},
    {"leaf_breadth", "", "", 0.3f, 2.0f, 0.0f, 1.0f, false},
    {"leaf_fold", "", "", 0.0f, 80.0f, 0.0f, 15.0f, false},
    {"particles", "", "", 10.0f, 100000.0f, 0.0f, 6000.0f, true},
    {"pattern", "", "", 0.0f, 3.0f, 0.0f, 3.0f, true},
    {"step", "", "", 0.05f, 2.0f, 0.0f, 0.35f, false},
    {"merge", "", "", 0.1f, 4.0f, 0.0f, 0.7f, false},
    {"neighbourhood", "", "", 0.0f, 100.0f, 0.0f, 0.0f, false},
    {"energy", "", "", 0.01f, 100.0f, 0.0f, 1.0f, false},
    {"pull", "", "", 0.0f, 4.0f, 0.0f, 1.0f, false},
    {"rule", "", "", 0.0f, 1.0f, 0.0f, 0.0f, true},
    {"age", "", "", 0.0f, 100.0f, 0.0f, 100.0f, false},
    {"life", "", "", 0.0f, 1.0f, 0.0f, 0.0f, true},
    {"day", "", "", 6.0f, 20.0f, 0.0f, 16.0f, false},
    {"hormone", "", "", 0.0f, 1.0f, 0.0f, 0.0f, false},
}};
// clang-format on

}  // namespace panicle::particles::tree
