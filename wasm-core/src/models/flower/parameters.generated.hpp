// Made from wasm-core/parameters/flower.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace panicle::flower {

// In the order of the request's words.
enum class Parameter : std::uint32_t {
  steps,
  age,
  smooth,
};

inline constexpr std::uint32_t parameter_count = 3;

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
    {"steps", "", "", 0.0f, 400.0f, 0.0f, 0.0f, true},
    {"age", "", "", 0.0f, 2.0f, 0.0f, 1.0f, false},
    {"smooth", "", "", 0.0f, 3.0f, 0.0f, 1.0f, true},
}};
// clang-format on

}  // namespace panicle::flower
