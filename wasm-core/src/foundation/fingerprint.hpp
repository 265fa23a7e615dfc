// FNV-1a hash, 64 bits wide, fed whole 32-bit words instead of bytes (Fowler, Noll, Vo; prime and offset are theirs).
// docs/fingerprint.md lists the words that are hashed, so that a fingerprint can be recomputed from the JSON.
#pragma once

#include <cstdint>
#include <span>

#include "foundation/bits.hpp"

namespace panicle {

class Fingerprint {
 public:
  // Its bits; −0 counts as 0, every NaN as the same one, for machines disagree about a NaN's sign and payload.
  void add(float value) {
    constexpr std::uint32_t quiet_nan = 0x7fc00000u;
    add(value == value ? bit_cast<std::uint32_t>(value + 0.0f) : quiet_nan);
  }
  // Mixes a word into the hash (FNV-1a, by words).
  void add(std::uint32_t word) { state_ = (state_ ^ word) * 1099511628211u; }
  void add(std::span<const float> values);
  void add(std::span<const std::uint32_t> words);
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 14695981039346656037ull;
};

}  // namespace panicle
