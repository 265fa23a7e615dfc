// The random values of flowers: each depends on the flower's address and the seed alone.
#pragma once

#include <cstdint>
#include <string_view>

#include "foundation/random.hpp"
#include "models/bunch/derived_bunch.hpp"
#include "models/bunch/natural/flowers.hpp"

namespace panicle::bunch {

// A random value of a bunch, 0 … 1, from the stream of that name. The second bunch has values of its own.
inline float bunch_random_value(std::uint64_t seed, std::string_view stream, std::uint64_t address,
                                std::uint32_t bunch) {
  return random_unit(bunch ? second_seed(seed) : seed, hash_text(stream), address);
}
// A random number, 0 … 1, of a flower for one purpose, named by `stream`.
inline float random_value_of(const Flower& flower, std::uint64_t seed, std::string_view stream) {
  return bunch_random_value(seed, stream, flower.address, flower.bunch);
}

}  // namespace panicle::bunch
