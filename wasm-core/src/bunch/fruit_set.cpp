#include "bunch/fruit_set.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "bunch/neighbours.hpp"

namespace panicle::bunch {
namespace {

constexpr float ramp = 0.12f;         // of the ranks that set: those whose berries are smaller
constexpr float least_share = 0.01f;  // of a berry's volume; less does not count as one

}  // namespace

std::vector<float> choose_set(std::span<const Bud> buds, float berries, float size) {
  std::vector<glm::vec3> places;
  for (const Bud& bud : buds) places.push_back(bud.place);
  const float near = 1.2f * size;
  const Neighbours grid(places, near);
  std::vector<float> ranks(buds.size());
  for (std::size_t i = 0; i < buds.size(); ++i) {
    float crowd = 0;
    grid.visit(places[i], [&](std::uint32_t j) {
      const glm::vec3 between = places[j] - places[i];
      const float within = 1 - glm::dot(between, between) / (near * near);
      if (within > 0) crowd += within * within * buds[j].strength;
    });
    ranks[i] = buds[i].chance * crowd * (1 + 4 * buds[i].misplaced) / std::max(1e-6f, buds[i].strength);
  }
  std::vector<float> sorted = ranks;
  std::sort(sorted.begin(), sorted.end());
  std::vector<float> shares(buds.size(), 1);
  if (sorted.empty() || berries >= static_cast<float>(sorted.size())) return shares;
  const auto whole = static_cast<std::size_t>(berries);
  const float next = sorted[std::min(whole + 1, sorted.size() - 1)];
  const float last = sorted[whole] + (next - sorted[whole]) * (berries - static_cast<float>(whole));
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const float share = std::clamp((last - ranks[i]) / (ramp * last), 0.0f, 1.0f);
    shares[i] = share < least_share ? 0 : share;
  }
  return shares;
}

}  // namespace panicle::bunch
