#include "foundation/random.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "foundation/bits.hpp"

using namespace panicle;

namespace {

// Pearson's statistic less its mean, in standard deviations: within ±4 for honest bins but once in 16,000 times.
double chi_square_score(const std::vector<int>& bins) {
  double total = 0;
  for (const int bin : bins) total += bin;
  const double expected = total / static_cast<double>(bins.size());
  double statistic = 0;
  for (const int bin : bins) statistic += (bin - expected) * (bin - expected) / expected;
  const double freedom = static_cast<double>(bins.size()) - 1;
  return (statistic - freedom) / std::sqrt(2 * freedom);
}

constexpr std::uint64_t stream = 7;

}  // namespace

TEST_CASE("random_unit fills [0, 1) evenly, along addresses, streams and seeds, and in pairs") {
  std::vector<int> by_address(256), by_stream(256), by_seed(256), pairs(32 * 32);
  float least = 1, most = 0;
  for (std::uint64_t i = 0; i < 200000; ++i) {
    const float value = random_unit(1, stream, i);
    least = std::min(least, value);
    most = std::max(most, value);
    ++by_address[static_cast<std::size_t>(value * 256)];
    ++by_stream[static_cast<std::size_t>(random_unit(1, i, 1) * 256)];
    ++by_seed[static_cast<std::size_t>(random_unit(i, stream, 1) * 256)];
    const std::size_t next = static_cast<std::size_t>(random_unit(1, stream, i + 1) * 32);
    ++pairs[static_cast<std::size_t>(value * 32) * 32 + next];
  }
  CHECK(least >= 0);
  CHECK(least < 1e-4f);
  CHECK(most < 1);
  CHECK(most > 1 - 1e-4f);
  CHECK(std::fabs(chi_square_score(by_address)) < 4);
  CHECK(std::fabs(chi_square_score(by_stream)) < 4);
  CHECK(std::fabs(chi_square_score(by_seed)) < 4);
  CHECK(std::fabs(chi_square_score(pairs)) < 4);
}

TEST_CASE("streams, seeds and addresses are independent of one another") {
  const auto correlation = [](auto first, auto second) {
    const int count = 100000;
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += (first(i) - 0.5) * (second(i) - 0.5);
    return 12 * sum / count * std::sqrt(count);  // in standard deviations
  };
  const auto u = [](int i) { return random_unit(3, 1, static_cast<std::uint64_t>(i)); };
  CHECK(std::fabs(correlation(u, [](int i) { return random_unit(3, 2, static_cast<std::uint64_t>(i)); })) < 4);
  CHECK(std::fabs(correlation(u, [](int i) { return random_unit(4, 1, static_cast<std::uint64_t>(i)); })) < 4);
  CHECK(std::fabs(correlation(u, [](int i) { return random_unit(1, 3, static_cast<std::uint64_t>(i)); })) < 4);
  CHECK(std::fabs(correlation(u, [](int i) { return random_unit(3, 1, static_cast<std::uint64_t>(i) + 1); })) < 4);
}

TEST_CASE("every input bit moves about half of the output bits") {
  const auto flips = [](std::uint64_t seed, std::uint64_t s, std::uint64_t address, std::uint64_t base) {
    return std::popcount(base ^ random_bits(seed, s, address));
  };
  for (int bit = 0; bit < 64; ++bit) {
    const std::uint64_t mask = std::uint64_t{1} << bit;
    double total = 0;
    for (std::uint64_t i = 0; i < 200; ++i) {
      const std::uint64_t base = random_bits(i, stream, i * 3);
      total += flips(i ^ mask, stream, i * 3, base) + flips(i, stream ^ mask, i * 3, base) +
               flips(i, stream, (i * 3) ^ mask, base);
    }
    CHECK(total / 600 == doctest::Approx(32).epsilon(0.03));
  }
}

TEST_CASE("random_integer is uniform from end to end, both included") {
  std::vector<int> bins(13);
  for (std::uint64_t i = 0; i < 130000; ++i) {
    const std::int32_t value = random_integer(5, stream, i, -6, 6);
    REQUIRE(value >= -6);
    REQUIRE(value <= 6);
    ++bins[static_cast<std::size_t>(value + 6)];
  }
  CHECK(std::fabs(chi_square_score(bins)) < 4);
  CHECK(random_integer(1, 1, 1, 9, 9) == 9);
  CHECK(random_integer(1, 1, 1, 30, 20) == random_integer(1, 1, 1, 20, 30));
}

TEST_CASE("random_integer takes the widest range there is") {
  int negative = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) negative += random_integer(5, stream, i, INT32_MIN, INT32_MAX) < 0;
  CHECK(negative > 400);
  CHECK(negative < 600);
}

TEST_CASE("random_direction is of unit length and uniform on the sphere") {
  std::vector<int> bins(20 * 20);  // of equal area: height by angle
  double mean[3] = {0, 0, 0};
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const glm::vec3 d = random_direction(2, stream, i);
    REQUIRE(std::fabs(std::sqrt(double{d.x} * d.x + double{d.y} * d.y + double{d.z} * d.z) - 1) < 2e-7);
    for (int axis = 0; axis < 3; ++axis) mean[axis] += d[axis] / 100000.0;
    const int height = std::min(19, static_cast<int>((d.z + 1) * 10));
    const int angle = std::min(19, static_cast<int>((std::atan2(d.y, d.x) / 3.14159266 + 1) * 10));
    ++bins[static_cast<std::size_t>(height * 20 + angle)];
  }
  CHECK(std::fabs(chi_square_score(bins)) < 4);
  CHECK(std::fabs(mean[0]) + std::fabs(mean[1]) + std::fabs(mean[2]) < 0.02);
}

TEST_CASE("hash_text differs between texts, hash_combine depends on the order") {
  std::set<std::uint64_t> seen;
  for (int i = 0; i < 20000; ++i) seen.insert(hash_text(std::to_string(i)));
  seen.insert(hash_text(""));
  seen.insert(hash_text(std::string(1, '\0')));
  seen.insert(hash_text(std::string(2, '\0')));
  CHECK(seen.size() == 20003);
  CHECK(hash_combine(1, 2) != hash_combine(2, 1));
  CHECK(hash_combine(0, 0) != 0);
}

TEST_CASE("random values are frozen: links depend on them") {
  CHECK(hash_text("") == 0xe220a8397b1dcdafu);
  CHECK(hash_text("berry radius") == 0x7d63a983bd8f5efcu);
  CHECK(hash_combine(1, 2) == 0x081a5c1377856b73u);
  CHECK(random_bits(0, 0, 0) == 0xed10172cc0c96cf8u);
  CHECK(random_bits(1, 2, 3) == 0x2ee6c235b7d0c74cu);
  CHECK(random_unit(42, 1, 9) == 0x1.22d962p-1f);
  CHECK(random_integer(42, 1, 9, 20, 30) == 26);
  const glm::vec3 direction = random_direction(42, 1, 9);
  CHECK(bit_cast<std::uint32_t>(direction.x) == 0xbf7ca7b4u);
  CHECK(bit_cast<std::uint32_t>(direction.y) == 0x3db088dcu);
  CHECK(bit_cast<std::uint32_t>(direction.z) == 0x3e0b658cu);
}
