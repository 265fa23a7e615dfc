// Made from wasm-core/parameters/growth.measures.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <cstdint>

namespace panicle::growth {

// In the order of Grown::measures; docs/models/growth/measures.md has their units.
enum class Measure : std::uint32_t {
  height,
  spread,
  wood_length,
  wood_volume,
  trunk_width,
  leaf_count,
  leaf_area,
  leaf_index,
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

}  // namespace panicle::growth
