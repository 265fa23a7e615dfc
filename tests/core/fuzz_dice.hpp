// Random draws and sizes of fuzz tests. `npm test` draws the same each time. PANICLE_SEED draws others, and
// PANICLE_FUZZ sets how many texts a test tries: `npm run fuzz` and the long run set them.
#pragma once

#include <cstdint>
#include <cstdlib>

#include "foundation/random.hpp"

namespace panicle::tests {

// The number in an environment variable, or `standard` where it is not set.
inline std::uint64_t environment_number(const char* name, std::uint64_t standard) {
  const char* const text = std::getenv(name);
  return text == nullptr ? standard : std::strtoull(text, nullptr, 10);
}

// How many texts a test tries.
inline std::uint64_t fuzz_runs(std::uint64_t standard) { return environment_number("PANICLE_FUZZ", standard); }

// Mixed into the seed of every draw.
inline std::uint64_t fuzz_seed() { return environment_number("PANICLE_SEED", 0); }

// The draws for one text of one test.
class Dice {
 public:
  Dice(std::uint64_t test, std::uint64_t text) : seed_(test + (fuzz_seed() << 8)), text_(text) {}
  // 0 … count − 1.
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(random_integer(seed_, text_, drawn_++, 0, static_cast<std::int32_t>(count) - 1));
  }

 private:
  std::uint64_t seed_, text_, drawn_ = 0;
};

}  // namespace panicle::tests
