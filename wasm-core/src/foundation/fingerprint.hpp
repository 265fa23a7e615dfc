// The fingerprint: FNV-1a over 32-bit little-endian words, 64 bits wide. Documented in docs/fingerprint.md so that
// anyone can compute it again from the JSON.
#pragma once

#include <cstdint>
#include <span>

namespace panicle {

class Fingerprint {
 public:
  void add(float value);
  void add(std::uint32_t word);
  void add(std::span<const float> values);
  void add(std::span<const std::uint32_t> words);
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 14695981039346656037ull;
};

}  // namespace panicle
