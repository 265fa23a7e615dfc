// Made from wasm-core/parameters/growth.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace panicle::growth {

// In the order of the request's words.
enum class Parameter : std::uint32_t {
  steps,
  season,
  age,
  leaf_kind,
  leaf_size,
  leaf_many,
  leaf_breadth,
  leaf_fold,
  leaf_twig,
  leaf_stray,
  fallen,
  year,
  blossoms,
  blossom_size,
  bunches,
  shoot,
  order_ratio,
  age_ratio,
  bole,
  trunk_angle,
  branch_angle,
  turn,
  inertia,
  space,
  crook,
  hang,
  reach,
  leader,
  whorl,
  flat,
  cordon,
  twig,
  pipe,
  flare,
};

inline constexpr std::uint32_t parameter_count = 34;

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
    {"steps", "", "", 0.0f, 14.0f, 0.0f, 0.0f, true},
    {"season", "", "", 0.0f, 1.0f, 0.0f, 0.4f, false},
    {"age", "", "", 0.0f, 100.0f, 0.0f, 100.0f, false},
    {"leaf_kind", "", "", 0.0f, 12.0f, 0.0f, 6.0f, true},
    {"leaf_size", "", "", 0.2f, 60.0f, 0.0f, 14.0f, false},
    {"leaf_many", "", "", 1.0f, 12.0f, 0.0f, 3.0f, true},
    {"leaf_breadth", "", "", 0.3f, 2.0f, 0.0f, 1.0f, false},
    {"leaf_fold", "", "", 0.0f, 80.0f, 0.0f, 15.0f, false},
    {"leaf_twig", "", "", 1.0f, 12.0f, 0.0f, 1.0f, true},
    {"leaf_stray", "", "", 0.0f, 2.0f, 0.0f, 0.5f, false},
    {"fallen", "", "", 0.0f, 100.0f, 0.0f, 0.0f, false},
    {"year", "", "", 0.0f, 1.0f, 0.0f, 0.0f, true},
    {"blossoms", "", "", 0.0f, 8.0f, 0.0f, 0.0f, true},
    {"blossom_size", "", "", 0.5f, 15.0f, 0.0f, 3.0f, false},
    {"bunches", "", "", 0.0f, 3.0f, 0.0f, 0.0f, true},
    {"shoot", "", "", 0.1f, 3.0f, 0.0f, 0.9f, false},
    {"order_ratio", "", "", 0.3f, 1.0f, 0.0f, 0.78f, false},
    {"age_ratio", "", "", 0.5f, 1.0f, 0.0f, 0.93f, false},
    {"bole", "", "", 0.02f, 0.9f, 0.0f, 0.16f, false},
    {"trunk_angle", "", "", 5.0f, 110.0f, 0.0f, 60.0f, false},
    {"branch_angle", "", "", 5.0f, 110.0f, 0.0f, 45.0f, false},
    {"turn", "", "", 0.0f, 360.0f, 0.0f, 137.5f, false},
    {"inertia", "", "", 0.0f, 3.0f, 0.0f, 1.0f, false},
    {"space", "", "", 0.0f, 3.0f, 0.0f, 0.7f, false},
    {"crook", "", "", 0.0f, 1.0f, 0.0f, 0.08f, false},
    {"hang", "", "", 0.0f, 2.0f, 0.0f, 0.0f, false},
    {"reach", "", "", 0.0f, 1.0f, 0.0f, 0.0f, false},
    {"leader", "", "", 0.1f, 1.0f, 0.0f, 0.97f, false},
    {"whorl", "", "", 0.0f, 1.0f, 0.0f, 0.0f, false},
    {"flat", "", "", 0.0f, 1.0f, 0.0f, 0.0f, false},
    {"cordon", "", "", 0.0f, 3.0f, 0.0f, 0.0f, false},
    {"twig", "", "", 1.0f, 40.0f, 0.0f, 12.0f, false},
    {"pipe", "", "", 1.5f, 4.0f, 0.0f, 2.3f, false},
    {"flare", "", "", 0.0f, 1.0f, 0.0f, 0.3f, false},
}};
// clang-format on

}  // namespace panicle::growth
