// Random values as hashes: a value belongs to (seed, stream, address), never to "the n-th draw", so that adding a
// branch changes nothing elsewhere. The same arguments give the same value for ever: links depend on it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>

namespace panicle {

std::uint64_t hash_text(std::string_view text);                // of the bytes; a stream's name, for instance
std::uint64_t hash_combine(std::uint64_t a, std::uint64_t b);  // order matters; chains make paths
std::uint64_t random_bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t address);  // 64 uniform bits

float random_unit(std::uint64_t seed, std::uint64_t stream, std::uint64_t address);  // [0, 1), 24 bits

// Every whole number from `low` to `high`, both included and in either order, equally likely (to a relative 2^−32).
std::int32_t random_integer(std::uint64_t seed, std::uint64_t stream, std::uint64_t address, std::int32_t low,
                            std::int32_t high);

// A unit vector, uniform on the sphere.
glm::vec3 random_direction(std::uint64_t seed, std::uint64_t stream, std::uint64_t address);

}  // namespace panicle
