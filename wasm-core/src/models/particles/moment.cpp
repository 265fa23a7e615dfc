#include "models/particles/moment.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace panicle::particles {

Trails at_moment(const Trails& trails, float moment, float stride) {
  const std::size_t count = trails.size();
  if (count == 0 || moment >= static_cast<float>(trails.born[0])) return trails;
  std::vector<double> own = trails.energy;
  for (std::size_t i = 1; i < count; ++i) own[static_cast<std::size_t>(trails.next[i])] -= trails.energy[i];
  own[0] = 0;

  Trails young;
  std::vector<std::int32_t> number(count, -1);
  const auto add = [&](const glm::vec3& place, std::int32_t next, double energy, std::uint32_t born, std::int32_t particle) {
    young.places.push_back(place);
    young.next.push_back(next);
    young.energy.push_back(energy);
    young.born.push_back(born);
    young.particle.push_back(particle);
    return static_cast<std::int32_t>(young.size()) - 1;
  };
  number[0] = add(trails.places[0], -1, 0, trails.born[0], -1);
  for (std::size_t i = 1; i < count; ++i) {
    const auto left = static_cast<float>(trails.born[i]);
    const bool start = trails.particle[i] >= 0;
    if (left > moment && !start) continue;
    const auto next = static_cast<std::size_t>(trails.next[i]);
    const glm::vec3 way = trails.places[next] - trails.places[i];
    // When the place was there, and the particle could be: others may have been there before it.
    const float earliest = left + glm::length(way) / stride;
    const float there = next == 0 ? std::max(left + 1, earliest) : std::max(static_cast<float>(trails.born[next]), earliest);
    std::int32_t to = -1;
    if (left < moment && there <= moment)
      to = number[next];
    else if (left < moment)
      to = add(trails.places[i] + ((moment - left) / (there - left)) * way, -1, 0, trails.born[i], -1);
    number[i] = add(trails.places[i], to, own[i], trails.born[i], trails.particle[i]);
  }
  for (std::size_t i = young.size(); i-- > 1;)
    if (young.next[i] >= 0) young.energy[static_cast<std::size_t>(young.next[i])] += young.energy[i];
  return young;
}

}  // namespace panicle::particles
