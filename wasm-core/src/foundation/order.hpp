// Sorting by keys. One sort of whole words serves everybody: every type and every comparison of its own would bring a
// sort of its own into the .wasm.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace panicle {

// The places 0 … n − 1 in ascending order of their keys; equal keys in the order of their places. −0 is 0, every NaN
// comes last.
std::vector<std::uint32_t> order_of(std::span<const float> keys);
std::vector<std::uint32_t> order_of(std::span<const std::int32_t> keys);

}  // namespace panicle
