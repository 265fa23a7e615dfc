// Sums of divisors and their convolutions, exact in whole numbers (Kim, Kim and Cho 2013, equations 2 to 5).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "foundation/result.hpp"

namespace panicle {

// Which divisors d of n are summed up, each to a power a, and how.
struct DivisorRule {
  enum class Kind : std::uint8_t {
    all,          // σ_a(n) = Σ d^a
    residue,      // σ_{a,b}(n; m): those with d mod m = b
    alternating,  // σ̂_a(n): even ones count negative
    odd_quotient  // σ*_a(n): those whose n / d is odd
  };
  Kind kind = Kind::all;
  std::uint32_t power = 1;                   // a
  std::uint32_t remainder = 0, modulus = 1;  // b and m, of a residue
};

// The factor B in the argument of a divisor function, which makes it grow faster: B(x, y) = x^y (equation 5).
struct DivisorArgument {
  std::uint32_t base = 1, exponent = 0;
};

// Values of a rule at 0 (where it is 0), 1, 2 … last, by a sieve in n log n. Errors: limit, when `last` passes
// `max_divided`; bad_input, when a modulus is 0, or a sum passes 2⁵³, beyond which a number of a text is
// no longer exact: where it does.
inline constexpr std::uint32_t max_divided = 4'000'000;
Result<std::vector<std::int64_t>> divisor_sums(const DivisorRule& rule, std::uint32_t last);

// x^y · last, the greatest argument that `last` leads to. Error: limit, when that passes `max_divided`.
Result<std::uint32_t> greatest_argument(const DivisorArgument& argument, std::uint32_t last);

// Σ D(B k) · E(L (N − k)) for k from 1 to N − 1, of values from 0 on that reach far enough (equation 5). Error:
// bad_input, when the sum passes 2⁵³.
Result<std::int64_t> convolution_sum(std::span<const std::int64_t> branches, std::uint32_t branch_factor,
                                     std::span<const std::int64_t> leaves, std::uint32_t leaf_factor, std::uint32_t n);

}  // namespace panicle
