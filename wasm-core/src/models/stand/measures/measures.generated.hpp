// Made from wasm-core/parameters/stand.measures.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <cstdint>

namespace panicle::stand {

// In the order of Grown::measures; docs/models/stand/measures.md has their units.
enum class Measure : std::uint32_t {
  area,
  standing,
  density,
  spacing,
  cover,
};

inline constexpr std::uint32_t measure_count = 5;

}  // namespace panicle::stand
