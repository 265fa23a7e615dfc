#include "models/particles/trails.hpp"

namespace panicle::particles {

std::vector<std::uint32_t> tree_order(std::span<const std::int32_t> next) {
  const std::size_t count = next.size();
  // Who leads to each place: counted, then listed by place.
  std::vector<std::uint32_t> first(count + 1, 0), members(count), order{0};
  for (std::size_t i = 1; i < count; ++i) ++first[static_cast<std::size_t>(next[i]) + 1];
  for (std::size_t i = 0; i < count; ++i) first[i + 1] += first[i];
  std::vector<std::uint32_t> free(first.begin(), first.end() - 1);
  for (std::uint32_t i = 1; i < count; ++i) members[free[static_cast<std::size_t>(next[i])]++] = i;
  order.reserve(count);
  for (std::size_t at = 0; at < order.size(); ++at)
    for (std::uint32_t m = first[order[at]]; m < first[order[at] + 1]; ++m) order.push_back(members[m]);
  return order;
}

}  // namespace panicle::particles
