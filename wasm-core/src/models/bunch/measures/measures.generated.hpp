// Made from wasm-core/parameters/bunch.measures.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <cstdint>

namespace panicle::bunch {

// In the order of Grown::measures; docs/models/bunch/measures.md has their units.
enum class Measure : std::uint32_t {
  coverage,
  spill,
  coverage_front,
  coverage_side,
  spill_front,
  spill_side,
  bunch_length,
  bunch_width,
  peduncle_length,
  bunch_shape,
  wings,
  bunch_weight,
  berry_volume,
  hull_volume,
  outline_volume,
  density,
  fill_ratio,
  compactness,
  gap,
  contacts,
  berry_count,
  diameter,
  diameter_spread,
  berry_length,
  berry_width,
  uniformity,
  berry_shape,
  pedicel_length,
  berry_weight,
  visible_front,
  visible_side,
  visible_mean,
  pedicels_seen,
};

inline constexpr std::uint32_t measure_count = 33;

}  // namespace panicle::bunch
