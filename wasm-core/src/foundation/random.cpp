// The finaliser is a bijection of 64 bits in which every input bit moves about half of the output bits: xor-shifts
// and odd multipliers, with the constants that Stafford found best for this shape (variant 13 of "Better bit mixing",
// 2011, also used by SplitMix64: Steele, Lea and Flood 2014).

#include "foundation/random.hpp"

#include <cmath>

#include "foundation/mathematics.hpp"

namespace panicle {
namespace {

constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;  // 2^64 / φ: keeps 0 from being a fixed point

constexpr std::uint64_t finalise(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// The upper 24 of 32 bits as a float in [0, 1): all of them representable, so none is likelier by rounding.
float unit_of(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

}  // namespace

std::uint64_t hash_text(std::string_view text) {
  std::uint64_t state = golden;
  for (const char character : text) {
    state = (state ^ static_cast<unsigned char>(character)) * 0x100000001b3u;
  }
  return finalise(state ^ text.size());
}

// A bijection of `a` for fixed `b` and of `b` for fixed `a`, and not the same for (b, a).
std::uint64_t hash_combine(std::uint64_t a, std::uint64_t b) { return finalise(finalise(a + golden) + b); }

std::uint64_t random_bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t address) {
  return hash_combine(hash_combine(seed, stream), address);
}

float random_unit(std::uint64_t seed, std::uint64_t stream, std::uint64_t address) {
  return unit_of(static_cast<std::uint32_t>(random_bits(seed, stream, address) >> 32));
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
glm::vec3 random_direction(std::uint64_t seed, std::uint64_t stream, std::uint64_t address) {
  const std::uint64_t bits = random_bits(seed, stream, address);
  const double height = 2.0 * unit_of(static_cast<std::uint32_t>(bits >> 32)) - (1 - 0x1p-24);
  const double radius = std::sqrt((1 - height) * (1 + height));
  const SinCos around = sincos_degrees(360.0f * unit_of(static_cast<std::uint32_t>(bits)));
  return {static_cast<float>(radius * around.cosine), static_cast<float>(radius * around.sine),
          static_cast<float>(height)};
}

}  // namespace panicle
