// Made from wasm-core/parameters/grammar.measures.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <cstdint>

namespace panicle::grammar {

// In the order of Grown::measures; docs/models/grammar/measures.md has their units.
enum class Measure : std::uint32_t {
  height,
  spread,
  box_volume,
  modules,
  segments,
  line_length,
  line_volume,
  tips,
  forks,
  axes,
  axis_order,
  order,
  bifurcation,
  fork_angle,
  organs,
  polygons,
  leaf_area,
  areas,
  area_volume,
  clothed,
};

inline constexpr std::uint32_t measure_count = 20;

}  // namespace panicle::grammar
