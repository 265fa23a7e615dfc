// A flower's luck: its own for ever, whatever else grows.
#pragma once

#include <cstdint>
#include <string_view>

#include "foundation/random.hpp"
#include "models/bunch/natural/flowers.hpp"
#include "models/bunch/stock.hpp"

namespace panicle::bunch {

// 0 … 1, in what `stream` names. The second bunch has a luck of its own.
inline float bunch_random_value(std::uint64_t seed, std::string_view stream, std::uint64_t address, std::uint32_t bunch) {
  return random_unit(bunch ? second_seed(seed) : seed, hash_text(stream), address);
}
inline float random_value_of(const Flower& flower, std::uint64_t seed, std::string_view stream) {
  return bunch_random_value(seed, stream, flower.address, flower.bunch);
}

}  // namespace panicle::bunch
