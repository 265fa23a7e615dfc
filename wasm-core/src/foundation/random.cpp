#include "foundation/random.hpp"

#include <cmath>

#include "foundation/mathematics.hpp"

namespace panicle {

using random_detail::finalise;
using random_detail::golden;

// A hash of a text.
std::uint64_t hash_text(std::string_view text) {
  std::uint64_t state = golden;
  for (const char character : text) {
    state = (state ^ static_cast<unsigned char>(character)) * 0x100000001b3u;
  }
  return finalise(state ^ text.size());
}

// 64 random bits, determined by seed, stream and address.
std::uint64_t random_bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t address) {
  return hash_combine(hash_combine(seed, stream), address);
}

// A random number from 0 up to, not including, 1.
float random_unit(std::uint64_t seed, std::uint64_t stream, std::uint64_t address) {
  return RandomStream(seed, stream).unit(address);
}

// A random integer from `low` to `high`, both included.
std::int32_t random_integer(std::uint64_t seed, std::uint64_t stream, std::uint64_t address, std::int32_t low,
                            std::int32_t high) {
  if (low > high) return random_integer(seed, stream, address, high, low);
  const std::uint64_t bits = random_bits(seed, stream, address);
  const std::uint64_t count = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low) + 1;  // 1 … 2^32
  // ⌊bits · count / 2^64⌋ in halves. Counts that do not divide 2^64 are uneven by less than count / 2^64 ≤ 2^−32.
  const std::uint64_t index = ((bits >> 32) * count + (((bits & 0xffffffffu) * count) >> 32)) >> 32;
  return static_cast<std::int32_t>(low + static_cast<std::int64_t>(index));
}

// A random unit vector, uniform on the sphere: by Archimedes, the height of a uniform point is uniform.
glm::vec3 RandomStream::direction(std::uint64_t address) const {
  const auto [one, other] = units(address);
  const double height = 2.0 * one - (1 - 0x1p-24);
  const double radius = std::sqrt((1 - height) * (1 + height));
  const SinCos around = sincos_degrees(360.0f * other);
  return {static_cast<float>(radius * around.cosine), static_cast<float>(radius * around.sine),
          static_cast<float>(height)};
}

// The same for a single stream and address.
glm::vec3 random_direction(std::uint64_t seed, std::uint64_t stream, std::uint64_t address) {
  return RandomStream(seed, stream).direction(address);
}

}  // namespace panicle
