#include "models/particles/vein_orders.hpp"

#include <algorithm>

namespace panicle::particles {

// A trail is the way that a particle has gone, from its start to the target.

namespace {

// A vein belongs to the current order if it carries at least this share of the energy of the widest one left.
constexpr double share_of_widest = 1.0 / 9;

// The energy that flows through a vein where it begins.
double energy_of(const Vein& vein, std::span<const Trails> crowds) { return crowds[vein.crowd].energy[vein.places[1]]; }

// Divides trails into veins: at a fork the trail with the most energy continues the vein, the others begin one.
void add_veins(const Trails& trails, std::size_t crowd, std::vector<Vein>& veins) {
  const std::size_t count = trails.size();
  std::vector<std::int32_t> heaviest(count, -1), vein_at(count, -1);
  for (std::size_t i = 1; i < count; ++i) {
    if (trails.next[i] < 0) continue;
    std::int32_t& child = heaviest[static_cast<std::size_t>(trails.next[i])];
    if (child < 0 || trails.energy[i] > trails.energy[static_cast<std::size_t>(child)])
      child = static_cast<std::int32_t>(i);
  }
  for (std::size_t i = 1; i < count; ++i) {
    if (trails.next[i] < 0) continue;
    const auto next = static_cast<std::size_t>(trails.next[i]);
    if (vein_at[next] >= 0 && heaviest[next] == static_cast<std::int32_t>(i)) {
      vein_at[i] = vein_at[next];
    } else {
      vein_at[i] = static_cast<std::int32_t>(veins.size());
      veins.push_back({crowd, {static_cast<std::uint32_t>(next)}, vein_at[next], 1});
    }
    veins[static_cast<std::size_t>(vein_at[i])].places.push_back(static_cast<std::uint32_t>(i));
  }
}

}  // namespace

// Divides trails into veins and numbers their orders (1 primary, 2 secondary …): by their width among those whose
// parents have an order already.
std::vector<Vein> veins_of(std::span<const Trails> crowds) {
  std::vector<Vein> veins;
  for (std::size_t crowd = 0; crowd < crowds.size(); ++crowd) add_veins(crowds[crowd], crowd, veins);
  std::vector<std::vector<std::size_t>> children(veins.size());
  std::vector<std::size_t> candidates, left;
  for (std::size_t i = 0; i < veins.size(); ++i)
    if (veins[i].parent < 0)
      candidates.push_back(i);
    else
      children[static_cast<std::size_t>(veins[i].parent)].push_back(i);
  for (std::uint32_t order = 1; !candidates.empty(); ++order) {
    double widest = 0;
    for (const std::size_t i : candidates) widest = std::max(widest, energy_of(veins[i], crowds));
    left.clear();
    for (const std::size_t i : candidates) {
      if (energy_of(veins[i], crowds) < share_of_widest * widest) {
        left.push_back(i);
        continue;
      }
      veins[i].order = order;
      left.insert(left.end(), children[i].begin(), children[i].end());
    }
    std::swap(candidates, left);
  }
  return veins;
}

}  // namespace panicle::particles
