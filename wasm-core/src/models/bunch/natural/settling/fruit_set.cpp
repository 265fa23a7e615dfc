#include "models/bunch/natural/settling/fruit_set.hpp"

#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>
#include <utility>

#include "foundation/lanes.hpp"
#include "foundation/order.hpp"
#include "spatial/point_grid.hpp"

namespace panicle::bunch {
namespace {

constexpr float ramp = 0.09f;         // of the ranks that set: those whose berries are smaller
constexpr float least_share = 0.01f;  // of a berry's volume; less does not count as one
constexpr float near = 1.3f;          // reach of a bud's crowd, in berry widths

// The share of space that a crowd of 1 fills: the kernel (1 − r²/h²)² holds 32 π h³ / 105, a berry π / 6.
constexpr float fill_of_crowd = (1.0f / 6) / (32.0f / 105 * near * near * near);

// Buds in the order of a grid's slots, each property in an array of its own, so that four are processed at once.
class BudsBySlot {
 public:
  // Sorts the buds into a grid with cells as wide as `reach`.
  BudsBySlot(std::span<const Bud> buds, std::span<const glm::vec3> places, float reach) : grid_(places, reach) {
    constexpr std::size_t padding = 3;  // four can be read from any slot
    const std::span<const std::uint32_t> ids = grid_.ids();
    for (auto* values : {&x_, &y_, &z_, &strength_}) values->resize(ids.size() + padding);
    bunch_.resize(ids.size() + padding);
    for (std::size_t slot = 0; slot < ids.size(); ++slot) {
      const Bud& bud = buds[ids[slot]];
      x_[slot] = bud.place.x;
      y_[slot] = bud.place.y;
      z_[slot] = bud.place.z;
      strength_[slot] = bud.strength;
      bunch_[slot] = bud.bunch;
    }
  }

  // The sum, over the buds of its bunch within `reach` of a bud, of their strengths weighted by the kernel; added slot
  // by slot.
  float crowd_of(const Bud& bud, float reach) const {
    float crowd = 0;
    const float square = reach * reach;
    grid_.visit_runs(bud.place, [&](std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t slot = first; slot < end; slot += 4) {
        const Four x = load(&x_[slot]) - bud.place.x, y = load(&y_[slot]) - bud.place.y,
                   z = load(&z_[slot]) - bud.place.z;
        const Four within = 1 - (x * x + y * y + z * z) / square;
        std::uint32_t lanes = true_lanes(within > 0.0f);
        if (end - slot < 4) lanes &= (1u << (end - slot)) - 1;
        for (; lanes != 0; lanes &= lanes - 1) {
          const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
          if (bunch_[slot + lane] == bud.bunch) crowd += within[lane] * within[lane] * strength_[slot + lane];
        }
      }
    });
    return crowd;
  }

 private:
  PointGrid grid_;
  std::vector<float> x_, y_, z_, strength_;
  std::vector<std::uint32_t> bunch_;
};

// The volume of each bud's berry over a full one: 1 for ranks well below `limit`, 0 above it, and smaller on a ramp
// just below it.
std::vector<float> shares_below(std::vector<float> ranks, float limit) {
  for (float& rank : ranks) {
    const float share = limit > 0 ? std::clamp((limit - rank) / (ramp * limit), 0.0f, 1.0f) : rank <= limit;
    rank = share < least_share ? 0 : share;
  }
  return ranks;
}

}  // namespace

// The rank of each bud, the lowest setting first: its random chance times the share of space that the buds about it
// would fill with berries `size` wide; more for buds outside the outline, less for strong ones.
std::vector<float> ranks_of(std::span<const Bud> buds, float size) {
  std::vector<glm::vec3> places;
  for (const Bud& bud : buds) places.push_back(bud.place);
  const float reach = near * size;
  const BudsBySlot by_slot(buds, places, reach);
  std::vector<float> ranks(buds.size());
  for (std::size_t i = 0; i < buds.size(); ++i) {
    const float crowd = by_slot.crowd_of(buds[i], reach);
    ranks[i] = buds[i].chance * crowd * fill_of_crowd * (1 + 4 * buds[i].misplaced) / std::max(1e-6f, buds[i].strength);
  }
  return ranks;
}

// The volume of each bud's berry over a full one, if the buds of ranks below `fill` set.
std::vector<float> choose_set(std::vector<float> ranks, float fill) { return shares_below(std::move(ranks), fill); }

// The same if about `berries` buds set, those of the lowest ranks; a fraction is rounded.
std::vector<float> choose_count(std::vector<float> ranks, float berries) {
  const auto whole = static_cast<std::size_t>(berries + 0.5f);
  if (whole >= ranks.size()) return std::vector<float>(ranks.size(), 1);
  std::vector<float> sorted = ranks;
  std::sort(sorted.begin(), sorted.end());
  return shares_below(std::move(ranks), sorted[whole]);
}

// The buds' indices by ascending rank.
std::vector<std::uint32_t> setting_order(std::span<const float> ranks) { return order_of(ranks); }

}  // namespace panicle::bunch
