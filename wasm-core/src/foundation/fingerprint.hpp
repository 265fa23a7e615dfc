// The fingerprint: FNV-1a, 64 bits wide, fed whole 32-bit words instead of bytes (Fowler, Noll, Vo; prime and start
// are theirs). docs/fingerprint.md says which words a result is, so that anyone can compute it again from the JSON.
#pragma once

#include <cstdint>
#include <span>

namespace panicle {

class Fingerprint {
 public:
  void add(float value);  // its bits; −0 counts as 0, every NaN as the same one
  void add(std::uint32_t word);
  void add(std::span<const float> values);
  void add(std::span<const std::uint32_t> words);
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 14695981039346656037ull;
};

}  // namespace panicle
