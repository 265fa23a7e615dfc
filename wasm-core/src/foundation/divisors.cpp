#include "foundation/divisors.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace panicle {
namespace {

constexpr std::uint64_t block = 1 << 14;  // of sums that are at hand

// Whole numbers up to here are exact in a double, too; sums on the way have room beyond it.
constexpr std::int64_t exact = std::int64_t{1} << 53, room = std::int64_t{1} << 62;

Diagnostic inexact(const std::string& what) {
  return {Reason::bad_input,
          what + " is greater than 2^53, where numbers stop being exact: ask for fewer steps, or for a smaller power"};
}

bool within(std::int64_t value, std::int64_t limit) { return value >= -limit && value <= limit; }

// d^a with its sign in the sum; 0 for divisors that the rule excludes; beyond `exact` on overflow.
std::int64_t weight_of(const DivisorRule& rule, std::uint32_t d) {
  if (rule.kind == DivisorRule::Kind::residue && d % rule.modulus != rule.remainder) return 0;
  std::int64_t weight = rule.kind == DivisorRule::Kind::alternating && d % 2 == 0 ? -1 : 1;
  if (d == 1) return weight;
  for (std::uint32_t a = 0; a < rule.power; ++a) {
    weight *= d;
    if (!within(weight, exact)) return weight;
  }
  return weight;
}

// Adds the divisors of all numbers from `first` to `last` to their sums: each n = d · q with d ≤ q once, where d counts
// with q as its quotient and q with d.
void add_divisors(bool odd_quotients, std::span<const std::int64_t> weights, std::span<std::int64_t> sums,
                  std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t d = 1; d * d <= last; ++d) {
    const bool odd = d % 2 == 1;
    if (d * d >= first && (odd || !odd_quotients)) sums[d * d] += weights[d];
    std::uint64_t q = std::max(d + 1, (first + d - 1) / d);
    const std::uint64_t end = last / d + 1;
    if (!odd_quotients) {
      for (; q < end; ++q) sums[d * q] += weights[d] + weights[q];
      continue;
    }
    if (odd)
      for (std::uint64_t k = q; k < end; ++k) sums[d * k] += weights[k];
    for (q |= 1; q < end; q += 2) sums[d * q] += weights[d];
  }
}

}  // namespace

Result<std::vector<std::int64_t>> divisor_sums(const DivisorRule& rule, std::uint32_t last) {
  if (rule.kind == DivisorRule::Kind::residue && rule.modulus == 0)
    return Diagnostic{Reason::bad_input,
                      "divisors cannot be told by what is left of them modulo 0: give a modulus of 1 or more"};
  if (last > most_divided)
    return Diagnostic{Reason::limit, "divisor functions are worked out up to " + std::to_string(most_divided) +
                                         ", not up to " + std::to_string(last) +
                                         ": ask for fewer steps, or for a smaller base or exponent"};
  std::vector<std::int64_t> weights(last + std::size_t{1}), sums(last + std::size_t{1});
  for (std::uint32_t d = 1; d <= last; ++d) {
    weights[d] = weight_of(rule, d);
    // Tests d alone: d divides itself, and all its other divisors are smaller.
    if (!within(weights[d], exact)) return inexact("the sum of the divisors of " + std::to_string(d));
  }
  for (std::uint64_t first = 1; first <= last; first += block)
    add_divisors(rule.kind == DivisorRule::Kind::odd_quotient, weights, sums, first,
                 std::min<std::uint64_t>(first + block - 1, last));
  for (std::uint32_t n = 1; n <= last; ++n)
    if (!within(sums[n], exact)) return inexact("the sum of the divisors of " + std::to_string(n));
  return sums;
}

Result<std::uint32_t> greatest_argument(const DivisorArgument& argument, std::uint32_t last) {
  std::uint64_t product = last;
  for (std::uint32_t y = 0; y < argument.exponent && argument.base > 1 && product > 0 && product <= most_divided; ++y)
    product *= argument.base;
  if (argument.exponent > 0 && argument.base == 0) product = 0;
  if (product > most_divided)
    return Diagnostic{
        Reason::limit,
        std::to_string(argument.base) + "^" + std::to_string(argument.exponent) + " times " + std::to_string(last) +
            " is more than " + std::to_string(most_divided) +
            ", up to which divisor functions are worked out: ask for fewer steps, or for a smaller base or exponent"};
  return static_cast<std::uint32_t>(product);
}

Result<std::int64_t> convolution_sum(std::span<const std::int64_t> branches, std::uint32_t branch_factor,
                                     std::span<const std::int64_t> leaves, std::uint32_t leaf_factor, std::uint32_t n) {
  std::int64_t sum = 0;
  for (std::uint32_t k = 1; k < n; ++k) {
    const std::int64_t b = branches[std::size_t{branch_factor} * k], l = leaves[std::size_t{leaf_factor} * (n - k)];
    if (l != 0 && !within(b, exact / std::abs(l))) return inexact("the convolution sum for " + std::to_string(n));
    sum += b * l;
    if (!within(sum, room)) return inexact("the convolution sum for " + std::to_string(n));
  }
  if (!within(sum, exact)) return inexact("the convolution sum for " + std::to_string(n));
  return sum;
}

}  // namespace panicle
