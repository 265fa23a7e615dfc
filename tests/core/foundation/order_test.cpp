#include "foundation/order.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "foundation/random.hpp"

using namespace panicle;

TEST_CASE("order_of sorts places by their keys and is stable") {
  const std::vector<float> keys{
      2, -1, 0.5f, -0.0f, 0.0f, -1, std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
  CHECK(order_of(keys) == std::vector<std::uint32_t>{7, 1, 5, 3, 4, 2, 0, 6});
  const std::vector<std::int32_t> whole{3, -1, 0, -1, std::numeric_limits<std::int32_t>::min()};
  CHECK(order_of(whole) == std::vector<std::uint32_t>{4, 1, 3, 2, 0});
  CHECK(order_of(std::vector<float>{NAN, 1, -NAN, -2}) == std::vector<std::uint32_t>{3, 1, 0, 2});
  CHECK(order_of(std::span<const float>()).empty());
}

TEST_CASE("order_of equals a stable sort for random keys") {
  for (std::uint64_t round = 0; round < 50; ++round) {
    std::vector<float> keys(200);
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = std::floor(random_unit(round, 1, i) * 40 - 20) / 4;
    std::vector<std::uint32_t> expected(keys.size());
    std::iota(expected.begin(), expected.end(), 0u);
    std::stable_sort(expected.begin(), expected.end(), [&](auto a, auto b) { return keys[a] < keys[b]; });
    CHECK(order_of(keys) == expected);
  }
}
