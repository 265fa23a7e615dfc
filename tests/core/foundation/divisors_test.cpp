#include "foundation/divisors.hpp"

#include <doctest/doctest.h>

#include <numeric>

#include "foundation/english.hpp"
#include "foundation/random.hpp"

namespace panicle {
namespace {

using Kind = DivisorRule::Kind;
using Sums = std::vector<std::int64_t>;

std::int64_t power(std::int64_t base, std::uint32_t exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

// As it is defined, divisor by divisor.
std::int64_t direct(const DivisorRule& rule, std::int64_t n) {
  std::int64_t sum = 0;
  for (std::int64_t d = 1; d <= n; ++d) {
    if (n % d != 0) continue;
    if (rule.kind == Kind::residue && d % rule.modulus != rule.remainder) continue;
    if (rule.kind == Kind::odd_quotient && n / d % 2 == 0) continue;
    sum += (rule.kind == Kind::alternating && d % 2 == 0 ? -1 : 1) * power(d, rule.power);
  }
  return sum;
}

Sums sums_of(const DivisorRule& rule, std::uint32_t last) {
  const auto sums = divisor_sums(rule, last);
  REQUIRE(sums);
  return sums.value();
}

const std::vector<DivisorRule> rules = {
    {Kind::all, 0},           {Kind::all, 1},           {Kind::all, 3},         {Kind::residue, 1, 1, 2},
    {Kind::residue, 1, 0, 2}, {Kind::residue, 2, 2, 5}, {Kind::alternating, 1}, {Kind::alternating, 2},
    {Kind::odd_quotient, 1},  {Kind::odd_quotient, 3},
};

}  // namespace

TEST_CASE("sums of divisors are those of the paper's examples") {
  CHECK(sums_of({}, 3)[3] == 4);  // 1 + 3 (section 3.2)
  CHECK(sums_of({}, 12)[12] == 28);
  CHECK(sums_of({Kind::residue, 1, 1, 2}, 12)[12] == 4);      // 1 + 3
  CHECK(sums_of({Kind::alternating, 1}, 12)[12] == -20);      // 1 − 2 + 3 − 4 − 6 − 12
  CHECK(sums_of({Kind::odd_quotient, 1}, 12)[12] == 12 + 4);  // 12 / 12 and 12 / 4 are odd
  CHECK(sums_of({Kind::all, 0}, 12)[12] == 6);
  CHECK(sums_of({}, 0) == Sums{0});
}

TEST_CASE("a sieve of divisors agrees with their definition") {
  for (const DivisorRule& rule : rules) {
    CAPTURE(static_cast<int>(rule.kind));
    CAPTURE(rule.power);
    const Sums sums = sums_of(rule, 600);
    for (std::int64_t n = 1; n <= 600; ++n) REQUIRE(sums[static_cast<std::size_t>(n)] == direct(rule, n));
  }
}

TEST_CASE("sums of divisors are multiplicative where their rule is") {
  for (const DivisorRule& rule : rules) {
    // Remainders other than 1 modulo 2 do not select alternating divisors.
    if (rule.kind == Kind::residue && !(rule.remainder == 1 && rule.modulus == 2)) continue;
    const Sums sums = sums_of(rule, 40'000);
    for (std::size_t m = 1; m <= 200; ++m)
      for (std::size_t n = 1; n <= 200; ++n)
        if (std::gcd(m, n) == 1) REQUIRE(sums[m * n] == sums[m] * sums[n]);
  }
}

TEST_CASE("identities between divisor functions hold") {
  const Sums all = sums_of({}, 2000), star = sums_of({Kind::odd_quotient, 1}, 2000),
             hat = sums_of({Kind::alternating, 1}, 2000), odd = sums_of({Kind::residue, 1, 1, 2}, 2000),
             even = sums_of({Kind::residue, 1, 0, 2}, 2000);
  for (std::size_t n = 1; n <= 1000; ++n) {
    REQUIRE(odd[n] + even[n] == all[n]);
    REQUIRE(odd[n] - even[n] == hat[n]);
    REQUIRE(even[2 * n] == 2 * all[n]);
    REQUIRE(star[2 * n] == 2 * star[n]);
  }
}

// Besge to Liouville, 1862.
TEST_CASE("convolution sums satisfy Besge's identity") {
  const Sums sigma = sums_of({}, 500), cubes = sums_of({Kind::all, 3}, 500);
  for (std::uint32_t n = 2; n <= 500; ++n) {
    const auto sum = convolution_sum(sigma, 1, sigma, 1, n);
    REQUIRE(sum);
    REQUIRE(12 * sum.value() == 5 * cubes[n] + (1 - 6 * std::int64_t{n}) * sigma[n]);
  }
}

TEST_CASE("a convolution sum applies the factor of each argument") {
  const Sums sigma = sums_of({}, 40);
  // N = 3: σ(2 · 1) σ(4 · 2) + σ(2 · 2) σ(4 · 1) = 3 · 15 + 7 · 7
  CHECK(convolution_sum(sigma, 2, sigma, 4, 3).value() == 94);
  CHECK(convolution_sum(sigma, 2, sigma, 4, 1).value() == 0);
}

TEST_CASE("arguments of divisor functions grow by powers") {
  CHECK(greatest_argument({}, 12).value() == 12);
  CHECK(greatest_argument({3, 2}, 12).value() == 108);
  CHECK(greatest_argument({0, 1}, 12).value() == 0);
  CHECK(greatest_argument({0, 0}, 12).value() == 12);
  CHECK(greatest_argument({2, 4'000'000'000u}, 0).value() == 0);
  const auto too_great = greatest_argument({2, 4'000'000'000u}, 3);
  REQUIRE_FALSE(too_great);
  CHECK(too_great.error().reason == Reason::limit);
}

TEST_CASE("sums that would not be exact are refused, and those that are just exact are not") {
  // 2^53 is the last: σ_53 of 1 and 2 are 1 and 1 + 2^53.
  CHECK_FALSE(divisor_sums({Kind::all, 53}, 2));
  CHECK(sums_of({Kind::odd_quotient, 53}, 2)[2] == std::int64_t{1} << 53);
  CHECK(sums_of({Kind::all, 52}, 2)[2] == (std::int64_t{1} << 52) + 1);
  // Sums on the way may pass the limit, the result may not: −(2^53) + 1.
  CHECK(sums_of({Kind::alternating, 53}, 2)[2] == 1 - (std::int64_t{1} << 53));
  const auto none = divisor_sums({Kind::all, 4'000'000'000u}, 3);
  REQUIRE_FALSE(none);
  CHECK(none.error().reason == Reason::bad_input);
  CHECK(english(none.error().message).find("divisors of 2") != std::string::npos);
  CHECK(sums_of({Kind::all, 4'000'000'000u}, 1)[1] == 1);
  CHECK_FALSE(divisor_sums({Kind::residue, 1, 0, 0}, 2));
  CHECK(divisor_sums({}, max_divided + 1).error().reason == Reason::limit);

  const Sums large = {0, std::int64_t{1} << 30};
  CHECK_FALSE(convolution_sum(large, 1, large, 1, 2));
}

TEST_CASE("random arguments agree with direct sums") {
  for (std::uint64_t run = 0; run < 200; ++run) {
    std::uint64_t drawn = 0;
    const auto draw = [&](std::int32_t most) {
      return static_cast<std::uint32_t>(random_integer(7, run, drawn++, 0, most));
    };
    DivisorRule rule{static_cast<Kind>(draw(3)), draw(3), 0, 1 + draw(8)};
    rule.remainder = draw(static_cast<std::int32_t>(rule.modulus) - 1);
    const std::uint32_t last = 1 + draw(2999);
    REQUIRE(sums_of(rule, last)[last] == direct(rule, last));
  }
}

}  // namespace panicle
