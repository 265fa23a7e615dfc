#include "models/particles/gather.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "foundation/order.hpp"

namespace panicle::particles {

// A trail is the way that a particle has gone, from its start to the target.

namespace {

// Copies trails with new links: place i now leads to next[i]. Sorts the places in tree order, recomputes the energy
// that flows through each and the step at which it was first left, and drops places through which no particle passes.
// `stride` is a particle's way in a step.
Trails relinked(const Trails& trails, std::vector<std::int32_t> next, float stride) {
  const std::size_t count = trails.size();
  const std::vector<std::uint32_t> order = tree_order(next);

  // The energy of each place itself, then the energy that flows in; from the ends on.
  std::vector<double> energy = trails.energy;
  std::vector<float> first_left(trails.born.begin(), trails.born.end());
  for (std::size_t i = 1; i < count; ++i) energy[static_cast<std::size_t>(trails.next[i])] -= trails.energy[i];
  for (std::size_t i = 0; i < count; ++i)
    if (trails.particle[i] < 0) energy[i] = 0;
  std::vector<std::uint8_t> on_the_way(count, 0);
  for (std::size_t at = order.size(); at-- > 1;) {
    const std::uint32_t i = order[at];
    const auto to = static_cast<std::size_t>(next[i]);
    if (trails.particle[i] < 0 && !on_the_way[i]) continue;
    on_the_way[to] = 1;
    energy[to] += energy[i];
    if (to > 0 && next[i] != trails.next[i])
      first_left[to] =
          std::min(first_left[to], first_left[i] + glm::distance(trails.places[i], trails.places[to]) / stride);
  }
  Trails result;
  std::vector<std::int32_t> new_index(count, -1);
  for (const std::uint32_t i : order) {
    if (i > 0 && trails.particle[i] < 0 && !on_the_way[i]) continue;
    const std::int32_t to = i == 0 ? -1 : new_index[static_cast<std::size_t>(next[i])];
    new_index[i] =
        result.add(trails.places[i], to, energy[i], static_cast<std::uint32_t>(first_left[i]), trails.particle[i]);
  }
  // The target is as old as the last arrival at the axis.
  result.born[0] = 0;
  if (result.size() > 1) result.born[0] = 1 + *std::max_element(result.born.begin() + 1, result.born.end());
  return result;
}

}  // namespace

// Bundles the trails near the axis into one: places nearer than `reach` to it are linked in a chain along the axis,
// from the farthest to the target, as far as each sees the next.
Trails gathered(const Trails& trails, const Axis& axis, const Guide& guide, float reach, float stride) {
  std::vector<std::uint32_t> near;
  std::vector<float> nearness;
  for (std::uint32_t i = 1; i < trails.size(); ++i) {
    if (trails.particle[i] >= 0 || !(axis.distance(trails.places[i]) < reach)) continue;
    near.push_back(i);
    nearness.push_back(-std::fabs(trails.places[i].y - axis.foot().y));
  }
  std::vector<std::uint32_t> line;
  for (const std::uint32_t at : order_of(nearness)) line.push_back(near[at]);
  line.push_back(0);
  std::vector<std::int32_t> next = trails.next;
  for (std::size_t first = 0, end; first < line.size(); first = end) {
    end = first + 1;
    while (end < line.size() && guide.sees(trails.places[line[end - 1]], trails.places[line[end]])) ++end;
    // A trail leads to ever lower numbers, so from the lowest number of a stretch no trail leads back into it.
    const auto exit = std::min_element(line.begin() + static_cast<std::ptrdiff_t>(first),
                                       line.begin() + static_cast<std::ptrdiff_t>(end));
    for (std::size_t k = first; line[k] != *exit; ++k) next[line[k]] = static_cast<std::int32_t>(line[k + 1]);
  }
  return relinked(trails, std::move(next), stride);
}

}  // namespace panicle::particles
