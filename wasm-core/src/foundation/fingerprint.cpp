#include "foundation/fingerprint.hpp"

namespace panicle {

// Mixes all values into the hash, in their order.
void Fingerprint::add(std::span<const float> values) {
  for (const float value : values) add(value);
}

void Fingerprint::add(std::span<const std::uint32_t> words) {
  for (const std::uint32_t word : words) add(word);
}

}  // namespace panicle
