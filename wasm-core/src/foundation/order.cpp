#include "foundation/order.hpp"

#include <algorithm>

#include "foundation/bits.hpp"

namespace panicle {
namespace {

constexpr std::uint32_t sign = 0x80000000;

// Maps a key to a word whose order is that of the keys: negative floats have all bits inverted, others the sign bit.
// NaN is last.
std::uint32_t word_of(float key) {
  if (!(key == key)) return 0xffffffff;
  const auto bits = bit_cast<std::uint32_t>(key + 0.0f);
  return bits & sign ? ~bits : bits | sign;
}

// The same for integers: the sign bit is inverted.
std::uint32_t word_of(std::int32_t key) { return static_cast<std::uint32_t>(key) ^ sign; }

// The indices of the keys in ascending order; equal keys in theirs: word and index are sorted as one number.
template <class Key>
std::vector<std::uint32_t> sorted_indices(std::span<const Key> keys) {
  std::vector<std::uint64_t> words(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) words[i] = std::uint64_t{word_of(keys[i])} << 32 | i;
  std::sort(words.begin(), words.end());
  std::vector<std::uint32_t> order(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = static_cast<std::uint32_t>(words[i]);
  return order;
}

}  // namespace

std::vector<std::uint32_t> order_of(std::span<const float> keys) { return sorted_indices(keys); }
std::vector<std::uint32_t> order_of(std::span<const std::int32_t> keys) { return sorted_indices(keys); }

}  // namespace panicle
