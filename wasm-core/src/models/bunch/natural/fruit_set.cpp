#include "models/bunch/natural/fruit_set.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "environment/point_grid.hpp"
#include "foundation/order.hpp"

namespace panicle::bunch {
namespace {

constexpr float ramp = 0.09f;         // of the ranks that set: those whose berries are smaller
constexpr float least_share = 0.01f;  // of a berry's volume; less does not count as one
constexpr float near = 1.3f;          // reach of a bud's crowd, in berry widths

// What a crowd of 1 fills: the kernel (1 − r²/h²)² holds 32 π h³ / 105, a berry π / 6.
constexpr float fill_of_crowd = (1.0f / 6) / (32.0f / 105 * near * near * near);

std::vector<float> shares_below(std::vector<float> ranks, float limit) {
  for (float& rank : ranks) {
    const float share = limit > 0 ? std::clamp((limit - rank) / (ramp * limit), 0.0f, 1.0f) : rank <= limit;
    rank = share < least_share ? 0 : share;
  }
  return ranks;
}

}  // namespace

std::vector<float> ranks_of(std::span<const Bud> buds, float size) {
  std::vector<glm::vec3> places;
  for (const Bud& bud : buds) places.push_back(bud.place);
  const float reach = near * size;
  const PointGrid grid(places, reach);
  std::vector<float> ranks(buds.size());
  for (std::size_t i = 0; i < buds.size(); ++i) {
    float crowd = 0;
    grid.visit(places[i], [&](std::uint32_t j) {
      if (buds[j].bunch != buds[i].bunch) return;
      const glm::vec3 between = places[j] - places[i];
      const float within = 1 - glm::dot(between, between) / (reach * reach);
      if (within > 0) crowd += within * within * buds[j].strength;
    });
    ranks[i] = buds[i].chance * crowd * fill_of_crowd * (1 + 4 * buds[i].misplaced) / std::max(1e-6f, buds[i].strength);
  }
  return ranks;
}

std::vector<float> choose_set(std::vector<float> ranks, float fill) { return shares_below(std::move(ranks), fill); }

std::vector<float> choose_count(std::vector<float> ranks, float berries) {
  const auto whole = static_cast<std::size_t>(berries + 0.5f);
  if (whole >= ranks.size()) return std::vector<float>(ranks.size(), 1);
  std::vector<float> sorted = ranks;
  std::sort(sorted.begin(), sorted.end());
  return shares_below(std::move(ranks), sorted[whole]);
}

std::vector<std::uint32_t> setting_order(std::span<const float> ranks) { return order_of(ranks); }

}  // namespace panicle::bunch
