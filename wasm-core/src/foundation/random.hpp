// Random values as hashes: a value belongs to (seed, stream, address), never to "the n-th draw", so that adding a
// branch changes nothing elsewhere. The values for given arguments are frozen: links depend on them.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>
#include <utility>

namespace panicle {

namespace random_detail {

constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;  // 2^64 / φ: keeps 0 from being a fixed point

// A bijection of 64 bits in which every input bit moves about half of the output bits: xor-shifts and odd multipliers,
// with the constants that Stafford found best for this shape (variant 13 of "Better bit mixing", 2011, also used by
// SplitMix64: Steele, Lea and Flood 2014).
constexpr std::uint64_t finalise(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// The upper 24 of 32 bits as a float in [0, 1): all of them representable, so none is likelier by rounding.
inline float unit_of(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

}  // namespace random_detail

std::uint64_t hash_text(std::string_view text);  // of the bytes; a stream's name, for instance

// Order matters; chains make paths. A bijection of `a` for fixed `b` and of `b` for fixed `a`, and not the same for
// (b, a).
constexpr std::uint64_t hash_combine(std::uint64_t a, std::uint64_t b) {
  using namespace random_detail;
  return finalise(finalise(a + golden) + b);
}

std::uint64_t random_bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t address);  // 64 uniform bits

float random_unit(std::uint64_t seed, std::uint64_t stream, std::uint64_t address);  // [0, 1), 24 bits

// Every whole number from `low` to `high`, both included and in either order, equally likely (to a relative 2^−32).
std::int32_t random_integer(std::uint64_t seed, std::uint64_t stream, std::uint64_t address, std::int32_t low,
                            std::int32_t high);

// A unit vector, uniform on the sphere.
glm::vec3 random_direction(std::uint64_t seed, std::uint64_t stream, std::uint64_t address);

// The same values of one seed and stream, for many draws: half of the hash is computed once.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t stream)
      : state_(random_detail::finalise(hash_combine(seed, stream) + random_detail::golden)) {}

  // 64 random bits for an address.
  std::uint64_t bits(std::uint64_t address) const { return random_detail::finalise(state_ + address); }
  // A random number from 0 up to, not including, 1.
  float unit(std::uint64_t address) const {
    return random_detail::unit_of(static_cast<std::uint32_t>(bits(address) >> 32));
  }
  // Two values of one hash; the first equals `unit`.
  std::pair<float, float> units(std::uint64_t address) const {
    const std::uint64_t drawn = bits(address);
    return {random_detail::unit_of(static_cast<std::uint32_t>(drawn >> 32)),
            random_detail::unit_of(static_cast<std::uint32_t>(drawn))};
  }
  glm::vec3 direction(std::uint64_t address) const;

 private:
  std::uint64_t state_;
};

}  // namespace panicle
