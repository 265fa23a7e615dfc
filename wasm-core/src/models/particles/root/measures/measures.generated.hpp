// Made from wasm-core/parameters/root.measures.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <cstdint>

namespace panicle::particles::root {

// In the order of Grown::measures; docs/models/root/measures.md has their units.
enum class Measure : std::uint32_t {
  deepest,
  spread,
  root_volume,
  wood_length,
  wood_volume,
  collar_width,
  surface,
  density,
  tips,
  forks,
  order,
  order1,
  order2,
  order3,
  bifurcation,
  fork_angle,
};

inline constexpr std::uint32_t measure_count = 16;

}  // namespace panicle::particles::root
