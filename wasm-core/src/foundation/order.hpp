// Sorting by keys, by one shared function: templates for each type and comparison would enlarge the .wasm.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace panicle {

// Returns the places 0 … n − 1 in ascending order of their keys, stable. −0 equals 0, NaN come last.
std::vector<std::uint32_t> order_of(std::span<const float> keys);
std::vector<std::uint32_t> order_of(std::span<const std::int32_t> keys);

}  // namespace panicle
