#include "models/growth/coarse_leaf.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "mesh/simplification.hpp"

namespace panicle::growth {
namespace {

// Returns the leaf as a patch, closed by a fan from a point behind it, so that a change of its outline has a cost.
Patch closed_patch(const FlatLeaf& leaf) {
  Patch patch;
  const std::size_t count = leaf.between.size();
  for (std::size_t i = 0; i < count; ++i) patch.positions.emplace_back(leaf.points[2 * i], leaf.points[2 * i + 1], 0);
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> edges;
  for (std::size_t t = 0; t + 2 < leaf.triangles.size(); t += 3) {
    patch.triangles.push_back({leaf.triangles[t], leaf.triangles[t + 1], leaf.triangles[t + 2]});
    for (std::size_t k = 0; k < 3; ++k) edges[{leaf.triangles[t + k], leaf.triangles[t + (k + 1) % 3]}] = true;
  }
  patch.counted = static_cast<std::uint32_t>(patch.triangles.size());
  const auto behind = static_cast<std::uint32_t>(count);
  patch.positions.emplace_back(0, 0.5f, -1);
  for (const auto& [edge, present] : edges)
    if (present && edges.count({edge.second, edge.first}) == 0)
      patch.triangles.push_back({edge.second, edge.first, behind});
  patch.is_fixed.assign(count + 1, 0);
  patch.is_fixed[0] = patch.is_fixed[count] = 1;
  return patch;
}

}  // namespace

CoarseLeaf coarse_leaf(const FlatLeaf& leaf, std::uint32_t most) {
  const auto count = static_cast<std::uint32_t>(leaf.between.size());
  std::vector<std::uint32_t> into(count);
  for (std::uint32_t i = 0; i < count; ++i) into[i] = i;
  if (count > 0 && leaf.triangles.size() / 3 > most)
    for (const Collapse& collapse : thinning_of(closed_patch(leaf))) {
      // A vertex behind the leaf is none of it.
      if (collapse.vertex >= count || collapse.into >= count) break;
      into[collapse.vertex] = collapse.into;
      if (collapse.triangles <= most) break;
    }
  // Follows collapses to the vertex that is left.
  const auto left = [&](std::uint32_t vertex) {
    while (into[vertex] != vertex) vertex = into[vertex];
    return vertex;
  };
  CoarseLeaf coarse;
  std::vector<std::uint32_t> numbers(count, count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (into[i] != i) continue;
    numbers[i] = static_cast<std::uint32_t>(coarse.between.size());
    coarse.between.push_back(leaf.between[i]);
    for (std::size_t k = 0; k < 2; ++k) {
      coarse.points.push_back(leaf.points[2 * i + k]);
      coarse.uvs.push_back(leaf.uvs[2 * i + k]);
    }
  }
  for (std::size_t t = 0; t + 2 < leaf.triangles.size(); t += 3) {
    const std::array<std::uint32_t, 3> corners{left(leaf.triangles[t]), left(leaf.triangles[t + 1]),
                                               left(leaf.triangles[t + 2])};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (const std::uint32_t corner : corners) coarse.triangles.push_back(numbers[corner]);
  }
  return coarse;
}

}  // namespace panicle::growth
