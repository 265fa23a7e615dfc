// Made from wasm-core/parameters/leaf.measures.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <cstdint>

namespace panicle::particles::leaf {

// In the order of Grown::measures; docs/models/leaf/measures.md has their units.
enum class Measure : std::uint32_t {
  area,
  perimeter,
  leaf_length,
  leaf_width,
  slenderness,
  roundness,
  vein_length,
  vein_density,
  vein_area,
  ends,
  forks,
  orders,
  count_1,
  count_2,
  count_3,
  density_1,
  density_2,
  density_3,
  primary_angle,
  secondary_angle,
  secondary_spacing,
};

inline constexpr std::uint32_t measure_count = 21;

}  // namespace panicle::particles::leaf
