// Profiles for tests of the natural procedure.
#pragma once

#include <algorithm>
#include <cstdint>

#include "foundation/random.hpp"
#include "models/bunch/specimens.hpp"

namespace panicle::tests {

// A profile that a person might draw: wide enough for berries.
inline bunch::Profile drawn_profile(std::uint64_t seed) {
  const auto pick = [seed](std::uint64_t k, std::int32_t low, std::int32_t high) {
    return static_cast<float>(random_integer(seed, hash_text("drawn"), k, low, high));
  };
  bunch::Profile profile{pick(0, 200, 560), {}};
  for (std::uint64_t i = 0; i < 4; ++i)
    profile.sides[i] = {pick(1 + i, 40, 220), std::min(pick(5 + i, 20, 260), 0.9f * profile.length)};
  return profile;
}

}  // namespace panicle::tests
