#include "foundation/fingerprint.hpp"

#include "foundation/bits.hpp"

namespace panicle {

void Fingerprint::add(std::uint32_t word) { state_ = (state_ ^ word) * 1099511628211u; }

void Fingerprint::add(float value) {
  constexpr std::uint32_t quiet_nan = 0x7fc00000u;  // machines disagree about a NaN's sign and payload
  add(value == value ? bit_cast<std::uint32_t>(value + 0.0f) : quiet_nan);
}

void Fingerprint::add(std::span<const float> values) {
  for (const float value : values) add(value);
}

void Fingerprint::add(std::span<const std::uint32_t> words) {
  for (const std::uint32_t word : words) add(word);
}

}  // namespace panicle
