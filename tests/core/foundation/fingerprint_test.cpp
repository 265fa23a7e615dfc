#include "foundation/fingerprint.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

using namespace panicle;

namespace {

template <class... Words>
std::uint64_t of(Words... words) {
  Fingerprint fingerprint;
  (fingerprint.add(words), ...);
  return fingerprint.value();
}

}  // namespace

TEST_CASE("the fingerprint of no data is FNV's offset; each word is xor, then times the prime") {
  CHECK(of() == 0xcbf29ce484222325u);
  CHECK(of(0u) == 0xcbf29ce484222325u * 0x100000001b3u);
  CHECK(of(1u, 2u) == ((0xcbf29ce484222325u ^ 1) * 0x100000001b3u ^ 2) * 0x100000001b3u);
}

TEST_CASE("a float is hashed by its bits, with −0 as 0 and all NaN alike") {
  CHECK(of(1.0f) == of(0x3f800000u));
  CHECK(of(-0.0f) == of(0.0f));
  CHECK(of(-0.0f) == of(0u));
  CHECK(of(-1.0f) != of(1.0f));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(of(nan) == of(-nan));
  CHECK(of(std::numeric_limits<float>::denorm_min()) == of(1u));
}

TEST_CASE("order matters, and spans are their elements") {
  CHECK(of(1.0f, 2.0f) != of(2.0f, 1.0f));
  const std::vector<float> values = {1, 2, 3};
  const std::vector<std::uint32_t> words = {4, 5};
  Fingerprint fingerprint;
  fingerprint.add(std::span<const float>(values));
  fingerprint.add(std::span<const std::uint32_t>(words));
  CHECK(fingerprint.value() == of(1.0f, 2.0f, 3.0f, 4u, 5u));
}

TEST_CASE("the example of docs/fingerprint.md") {
  CHECK(of(-1.0f, 0.0f, -1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, -0.0125f, 0.0f, 0.00125f, 0.00125f,  //
           0.0f, 3.0f, -1.0f, 0.0f, 0.0f, -0.0125f, 0.0f, 0.0f, -0.015f, -0.0f, 0.001f, 0.001f,   //
           0.0f, -0.02125f, 0.0f, 0.00625f, 1.0f) == 0x6454a3dd121d9250u);
}
