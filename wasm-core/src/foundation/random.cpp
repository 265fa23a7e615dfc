#include "foundation/random.hpp"

#include <cmath>

#include "foundation/mathematics.hpp"

namespace panicle {

using random_detail::finalise;
using random_detail::golden;

std::uint64_t hash_text(std::string_view text) {
  std::uint64_t state = golden;
  for (const char character : text) {
    state = (state ^ static_cast<unsigned char>(character)) * 0x100000001b3u;
  }
  return finalise(state ^ text.size());
}

std::uint64_t random_bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t address) {
  return hash_combine(hash_combine(seed, stream), address);
}

float random_unit(std::uint64_t seed, std::uint64_t stream, std::uint64_t address) {
  return RandomStream(seed, stream).unit(address);
}

std::int32_t random_integer(std::uint64_t seed, std::uint64_t stream, std::uint64_t address, std::int32_t low,
                            std::int32_t high) {
  if (low > high) return random_integer(seed, stream, address, high, low);
  const std::uint64_t bits = random_bits(seed, stream, address);
  const std::uint64_t count = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low) + 1;  // 1 … 2^32
  // ⌊bits · count / 2^64⌋ in halves. Counts that do not divide 2^64 are uneven by less than count / 2^64 ≤ 2^−32.
  const std::uint64_t index = ((bits >> 32) * count + (((bits & 0xffffffffu) * count) >> 32)) >> 32;
  return static_cast<std::int32_t>(low + static_cast<std::int64_t>(index));
}

// Archimedes: the height of a uniform point on the sphere is uniform.
glm::vec3 RandomStream::direction(std::uint64_t address) const {
  const std::uint64_t bits = hash_combine(state_, address);
  const double height = 2.0 * random_detail::unit_of(static_cast<std::uint32_t>(bits >> 32)) - (1 - 0x1p-24);
  const double radius = std::sqrt((1 - height) * (1 + height));
  const SinCos around = sincos_degrees(360.0f * random_detail::unit_of(static_cast<std::uint32_t>(bits)));
  return {static_cast<float>(radius * around.cosine), static_cast<float>(radius * around.sine),
          static_cast<float>(height)};
}

glm::vec3 random_direction(std::uint64_t seed, std::uint64_t stream, std::uint64_t address) {
  return RandomStream(seed, stream).direction(address);
}

}  // namespace panicle
