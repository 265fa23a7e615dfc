// Default rules in the growth language, which come before a grammar that has no rules of its own for the matter. They
// are calibrated to Table 1 of Kim, Kim and Cho (2013), whose own rule was lost in print; see
// docs/models/growth/growth.md.
#pragma once

#include <string_view>

namespace panicle::growth {

// Section 3.3: the trunk is the branch whose k is N − 1.
inline constexpr std::string_view standard_counts = R"(
k == N - 1 -> ndv = D(B * k), nbr = abs(ndv)
k < N - 1 -> ndv = D(B * k) - D(B * (k - 1)), nbr = ndv
)";

inline constexpr std::string_view standard_buds = "bud(k - 1) : k < N - 1 -> branch : 0.9\n";

inline constexpr std::string_view standard_leaves = R"(
k == N - 1 -> nlf = E(L)
k < N - 1 -> nlf = E(L * (N - k)) - E(L * (N - k - 1))
nlf > 0 -> leaf(nlf)
nlf < 0 -> fallingLeaf(-nlf)
)";

}  // namespace panicle::growth
