// Made from wasm-core/parameters/grammar.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace panicle::grammar {

// In the order of the request's words.
enum class Parameter : std::uint32_t {
  unit,
  thickness,
  thickening,
  widths,
  sides,
};

inline constexpr std::uint32_t parameter_count = 5;

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
    {"unit", "", "", 0.01f, 10000.0f, 0.0f, 10.0f, false},
    {"thickness", "", "", 0.1f, 200.0f, 0.0f, 8.0f, false},
    {"thickening", "", "", 0.0f, 0.6f, 0.0f, 0.3f, false},
    {"widths", "", "", 0.01f, 1000.0f, 0.0f, 100.0f, false},
    {"sides", "", "", 3.0f, 32.0f, 0.0f, 10.0f, true},
}};
// clang-format on

}  // namespace panicle::grammar
