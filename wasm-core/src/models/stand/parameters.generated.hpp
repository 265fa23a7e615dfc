// Made from wasm-core/parameters/stand.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace panicle::stand {

// In the order of the request's words.
enum class Parameter : std::uint32_t {
  many,
  relief,
};

inline constexpr std::uint32_t parameter_count = 2;

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
    {"many", "", "", 0.0f, 3000.0f, 0.0f, 0.0f, true},
    {"relief", "", "", 0.0f, 3.0f, 0.0f, 1.0f, false},
}};
// clang-format on

}  // namespace panicle::stand
