// Random values as hashes: a value belongs to (seed, stream, address), never to "the n-th draw".
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>

namespace panicle {

std::uint64_t hash_text(std::string_view text);
std::uint64_t hash_combine(std::uint64_t a, std::uint64_t b);
std::uint64_t random_bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t address);

float random_unit(std::uint64_t seed, std::uint64_t stream, std::uint64_t address);  // [0, 1), 24 bits
// Every whole number from `low` to `high`, both included, equally likely.
std::int32_t random_integer(std::uint64_t seed, std::uint64_t stream, std::uint64_t address, std::int32_t low,
                            std::int32_t high);
glm::vec3 random_direction(std::uint64_t seed, std::uint64_t stream, std::uint64_t address);  // uniform on the sphere

}  // namespace panicle
