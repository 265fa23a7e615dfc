#include "models/particles/trails.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace panicle::particles {

// A trail is the way that a particle has gone, from its start to the target; the energy of a place is the sum over all
// particles that pass it.

// Reserves memory for so many points.
void Trails::reserve(std::size_t count) {
  places.reserve(count);
  next.reserve(count);
  energy.reserve(count);
  born.reserve(count);
  particle.reserve(count);
}

// Adds a place that leads to the place `to`, through which the energy `passing` flows, first left at the step
// `first_left`; `started` is the particle that starts there or −1. Returns its index.
std::int32_t Trails::add(const glm::vec3& place, std::int32_t to, double passing, std::uint32_t first_left,
                         std::int32_t started) {
  places.push_back(place);
  next.push_back(to);
  energy.push_back(passing);
  born.push_back(first_left);
  particle.push_back(started);
  return static_cast<std::int32_t>(size()) - 1;
}

// The step at which a particle that leaves place i arrives at its next one, at `stride` a step: not before that place
// was left itself.
float arrival(const Trails& trails, std::size_t i, float stride) {
  const auto next = static_cast<std::size_t>(trails.next[i]);
  const auto left = static_cast<float>(trails.born[i]);
  const float earliest = left + glm::distance(trails.places[i], trails.places[next]) / stride;
  return std::max(next == 0 ? left + 1 : static_cast<float>(trails.born[next]), earliest);
}

// The order of places breadth first from the target, place 0, so that each comes after its next.
std::vector<std::uint32_t> tree_order(std::span<const std::int32_t> next) {
  const std::size_t count = next.size();
  // Places that lead to each place: counted, then listed by place.
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
