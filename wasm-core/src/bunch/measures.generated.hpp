// Made from wasm-core/parameters/measures.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <cstdint>

namespace panicle::bunch {

// In the order of Grown::measures.
enum class Measure : std::uint32_t {
  coverage,  // 0 … 1
  spill,  // 0 … 1
  coverage_front,  // 0 … 1
  coverage_side,  // 0 … 1
  spill_front,  // 0 … 1
  spill_side,  // 0 … 1
  bunch_length,  // mm
  bunch_width,  // mm
  peduncle_length,  // mm
  bunch_shape,
  wings,
  bunch_weight,  // g
  berry_volume,  // cm³
  hull_volume,  // cm³
  outline_volume,  // cm³
  density,
  fill_ratio,  // 0 … 1
  compactness,  // g/cm²
  gap,  // mm
  contacts,
  berry_count,
  diameter,  // mm
  diameter_spread,  // 0 … 1
  berry_length,  // mm
  berry_width,  // mm
  uniformity,
  berry_shape,
  pedicel_length,  // mm
  berry_weight,  // g
  visible_front,  // 0 … 1
  visible_side,  // 0 … 1
  visible_mean,  // 0 … 1
  pedicels_seen,  // 0 … 1
};

inline constexpr std::uint32_t measure_count = 33;

}  // namespace panicle::bunch
