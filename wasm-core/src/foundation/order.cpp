#include "foundation/order.hpp"

#include <algorithm>

#include "foundation/bits.hpp"

namespace panicle {
namespace {

constexpr std::uint32_t sign = 0x80000000;

// Maps keys to words whose order is that of the keys.
std::uint32_t word_of(float key) {
  if (!(key == key)) return 0xffffffff;
  const auto bits = bit_cast<std::uint32_t>(key + 0.0f);
  return bits & sign ? ~bits : bits | sign;
}

std::uint32_t word_of(std::int32_t key) { return static_cast<std::uint32_t>(key) ^ sign; }

template <class Key>
std::vector<std::uint32_t> places(std::span<const Key> keys) {
  std::vector<std::uint64_t> words(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) words[i] = std::uint64_t{word_of(keys[i])} << 32 | i;
  std::sort(words.begin(), words.end());
  std::vector<std::uint32_t> order(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = static_cast<std::uint32_t>(words[i]);
  return order;
}

}  // namespace

std::vector<std::uint32_t> order_of(std::span<const float> keys) { return places(keys); }
std::vector<std::uint32_t> order_of(std::span<const std::int32_t> keys) { return places(keys); }

}  // namespace panicle
