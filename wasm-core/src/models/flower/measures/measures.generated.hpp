// Made from wasm-core/parameters/flower.measures.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <cstdint>

namespace panicle::flower {

// In the order of Grown::measures; docs/models/flower/measures.md has their units.
enum class Measure : std::uint32_t {
  height,
  spread,
  surface,
  organs,
};

inline constexpr std::uint32_t measure_count = 4;

}  // namespace panicle::flower
