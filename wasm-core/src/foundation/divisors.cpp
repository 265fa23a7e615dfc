#include "foundation/divisors.hpp"

#include <algorithm>
#include <cstdlib>

#include "foundation/messages.generated.hpp"

namespace panicle {
namespace {

constexpr std::uint64_t block = 1 << 14;  // of sums that are at hand

// Whole numbers up to here are exact in a double, too; sums on the way have room beyond it.
constexpr std::int64_t exact = std::int64_t{1} << 53, room = std::int64_t{1} << 62;

// The error for a sum that doubles cannot represent exactly.
Diagnostic inexact(const MessageCode<1>& what, std::uint32_t number) { return bad_input(message(what, number)); }

// Whether a value is at most `limit` from 0.
bool within(std::int64_t value, std::int64_t limit) { return value >= -limit && value <= limit; }

// The weight of divisor `d` in the sum: d to the rule's power, with its sign; 0 if the rule excludes it. A result
// beyond `exact` means overflow.
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

// For each n up to `last` the sum over its divisors d of their weights; an error if one is not exact.
Result<std::vector<std::int64_t>> divisor_sums(const DivisorRule& rule, std::uint32_t last) {
  if (rule.kind == DivisorRule::Kind::residue && rule.modulus == 0)
    return bad_input(message(messages::foundation::divisor_modulus_zero));
  if (last > max_divided)
    return Diagnostic{Reason::limit, message(messages::foundation::divisor_function_too_far, max_divided, last)};
  std::vector<std::int64_t> weights(last + std::size_t{1}), sums(last + std::size_t{1});
  for (std::uint32_t d = 1; d <= last; ++d) {
    weights[d] = weight_of(rule, d);
    // Tests d alone: d divides itself, and all its other divisors are smaller.
    if (!within(weights[d], exact)) return inexact(messages::foundation::divisor_sum_not_exact, d);
  }
  for (std::uint64_t first = 1; first <= last; first += block)
    add_divisors(rule.kind == DivisorRule::Kind::odd_quotient, weights, sums, first,
                 std::min<std::uint64_t>(first + block - 1, last));
  for (std::uint32_t n = 1; n <= last; ++n)
    if (!within(sums[n], exact)) return inexact(messages::foundation::divisor_sum_not_exact, n);
  return sums;
}

// The greatest argument base^exponent · last of a divisor function; an error beyond the limit.
Result<std::uint32_t> greatest_argument(const DivisorArgument& argument, std::uint32_t last) {
  std::uint64_t product = last;
  for (std::uint32_t y = 0; y < argument.exponent && argument.base > 1 && product > 0 && product <= max_divided; ++y)
    product *= argument.base;
  if (argument.exponent > 0 && argument.base == 0) product = 0;
  if (product > max_divided)
    return Diagnostic{Reason::limit, message(messages::foundation::divisor_argument_too_large, argument.base,
                                             argument.exponent, last, max_divided)};
  return static_cast<std::uint32_t>(product);
}

// The sum over k = 1 … n − 1 of branches[b k] · leaves[l (n − k)], where b and l are the factors; an error if it is not
// exact.
Result<std::int64_t> convolution_sum(std::span<const std::int64_t> branches, std::uint32_t branch_factor,
                                     std::span<const std::int64_t> leaves, std::uint32_t leaf_factor, std::uint32_t n) {
  std::int64_t sum = 0;
  for (std::uint32_t k = 1; k < n; ++k) {
    const std::int64_t b = branches[std::size_t{branch_factor} * k], l = leaves[std::size_t{leaf_factor} * (n - k)];
    if (l != 0 && !within(b, exact / std::abs(l))) return inexact(messages::foundation::convolution_sum_not_exact, n);
    sum += b * l;
    if (!within(sum, room)) return inexact(messages::foundation::convolution_sum_not_exact, n);
  }
  if (!within(sum, exact)) return inexact(messages::foundation::convolution_sum_not_exact, n);
  return sum;
}

}  // namespace panicle
