// Made from wasm-core/parameters/bunch.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace panicle::bunch {

// In the order of the request's words.
enum class Parameter : std::uint32_t {
  l,
  p3w,
  p3r,
  p4w,
  p4r,
  p5w,
  p5r,
  p6w,
  p6r,
  unit,
  peduncle,
  variability,
  procedure,
  size,
  spread,
  density,
  count,
  elongation,
  taper,
  blunt,
  pedicel,
  fruit,
  age,
  sun,
  sun_height,
  sunlight,
  vigour,
  bend,
  leaves,
  cane,
  wing,
  wing_angle,
  wing_side,
  rmin,
  rmax,
  delta,
  t,
  sag,
  yaw,
  roll,
  li,
  lw,
  wi,
  rw,
  rrr,
  rrf,
  re,
  rff,
  rp,
  fit,
  vary,
};

inline constexpr std::uint32_t parameter_count = 51;

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
    {"l", "", "", 29.0f, 580.0f, 0.0f, 512.0f, false},
    {"p3w", "", "", 0.0f, 290.0f, 0.0f, 150.0f, false},
    {"p3r", "", "", 0.0f, 580.0f, 0.0f, 150.0f, false},
    {"p4w", "", "", 0.0f, 290.0f, 0.0f, 150.0f, false},
    {"p4r", "", "", 0.0f, 580.0f, 0.0f, 102.0f, false},
    {"p5w", "", "", 0.0f, 290.0f, 0.0f, 150.0f, false},
    {"p5r", "", "", 0.0f, 580.0f, 0.0f, 150.0f, false},
    {"p6w", "", "", 0.0f, 290.0f, 0.0f, 150.0f, false},
    {"p6r", "", "", 0.0f, 580.0f, 0.0f, 150.0f, false},
    {"unit", "", "", 0.05f, 2.0f, 0.0f, 0.25f, false},
    {"peduncle", "", "natural", 0.0f, 150.0f, 0.0f, 45.0f, false},
    {"variability", "", "natural", 0.0f, 2.0f, 0.0f, 1.0f, false},
    {"procedure", "", "", 0.0f, 1.0f, 0.0f, 1.0f, true},
    {"size", "", "natural", 3.0f, 60.0f, 0.0f, 18.0f, false},
    {"spread", "", "natural", 0.0f, 40.0f, 0.0f, 7.0f, false},
    {"density", "", "natural", 1.0f, 9.0f, 0.0f, 7.0f, false},
    {"count", "", "natural", 0.0f, 3000.0f, 0.0f, 0.0f, true},
    {"elongation", "", "natural", 0.7f, 3.5f, 0.0f, 1.04f, false},
    {"taper", "", "natural", -1.0f, 1.0f, 0.0f, 0.0f, false},
    {"blunt", "", "natural", 0.0f, 1.0f, 0.0f, 0.0f, false},
    {"pedicel", "", "natural", 1.0f, 60.0f, 0.0f, 8.0f, false},
    {"fruit", "", "natural", 0.0f, 5.0f, 0.0f, 0.0f, true},
    {"age", "", "natural", 0.0f, 125.0f, 0.0f, 100.0f, false},
    {"sun", "", "natural", 0.0f, 360.0f, 0.0f, 40.0f, false},
    {"sun_height", "", "natural", 0.0f, 90.0f, 0.0f, 45.0f, false},
    {"sunlight", "", "natural", 0.0f, 1.0f, 0.0f, 0.4f, false},
    {"vigour", "", "natural", 0.0f, 1.0f, 0.0f, 0.7f, false},
    {"bend", "", "natural", 0.0f, 1.0f, 0.0f, 0.3f, false},
    {"leaves", "", "natural", 0.0f, 5.0f, 0.0f, 0.0f, true},
    {"cane", "", "natural", 0.0f, 1.0f, 0.0f, 0.0f, true},
    {"wing", "", "", 0.0f, 1.0f, 0.3f, 0.0f, false},
    {"wing_angle", "", "", 25.0f, 120.0f, 0.0f, 55.0f, false},
    {"wing_side", "", "natural", 0.0f, 3.0f, 0.0f, 1.0f, true},
    {"rmin", "r_min", "paper", 2.0f, 80.0f, 0.0f, 20.0f, true},
    {"rmax", "r_max", "paper", 2.0f, 80.0f, 0.0f, 30.0f, true},
    {"delta", "", "paper", 0.0f, 90.0f, 0.0f, 15.0f, false},
    {"t", "", "paper", 0.0f, 200.0f, 0.0f, 50.0f, true},
    {"sag", "", "paper", 0.0f, 30.0f, 0.0f, 2.0f, false},
    {"yaw", "alpha_y", "", 0.0f, 150.0f, 0.0f, 60.0f, false},
    {"roll", "alpha_r", "paper", -180.0f, 180.0f, 0.0f, 120.0f, false},
    {"li", "l_i", "paper", 10.0f, 120.0f, 0.0f, 50.0f, false},
    {"lw", "l_w", "paper", 1.0f, 60.0f, 0.0f, 10.0f, false},
    {"wi", "w_i", "", 2.0f, 40.0f, 0.0f, 15.0f, false},
    {"rw", "r_w", "", 0.5f, 1.0f, 0.0f, 0.98f, false},
    {"rrr", "r_rr", "paper", 0.5f, 1.2f, 0.0f, 0.99f, false},
    {"rrf", "r_rf", "paper", 0.3f, 1.5f, 0.0f, 0.89f, false},
    {"re", "r_e", "paper", 0.2f, 1.5f, 0.0f, 0.6f, false},
    {"rff", "r_ff", "paper", 0.5f, 1.2f, 0.0f, 0.99f, false},
    {"rp", "r_p", "paper", 0.3f, 4.0f, 0.0f, 1.5f, false},
    {"fit", "", "paper", 0.0f, 1.0f, 0.0f, 1.0f, false},
    {"vary", "vary", "", 0.0f, 1.0f, 0.0f, 0.3f, false},
}};
// clang-format on

// What symbols draw where a grammar declares no roles.
struct RoleInfo {
  std::string_view role;
  std::string_view symbol;
  bool begins;  // whether it is the symbol's beginning only
};

inline constexpr std::array<RoleInfo, 3> role_table = {{
    {"rachis", "Ar", true},
    {"end", "Ae", false},
    {"pedicel", "Ap", false},
}};

}  // namespace panicle::bunch
