#include "models/particles/forks.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "foundation/mathematics.hpp"
#include "models/particles/polish.hpp"

namespace panicle::particles {

// A trail is the way that a particle has gone, from its start to the target; the energy of a place is the sum over all
// particles that pass it.

namespace {

// Power of the energy: with 1/2 even forks would open 90°, with 1 not at all; with this 42°.
constexpr float cost = 0.95f;
constexpr int passes = 16;
// Largest move of a place in a pass, over the distance to its nearest neighbour: less than half.
constexpr float most = 0.4f;

}  // namespace

// Moves the places of trails so that forks open at natural angles: each piece pulls at its ends with a force that grows
// with its energy, in several passes. Pieces stay longer than `nearest`, and places move at most `farthest`.
void narrow_forks(Trails& trails, const Guide& guide, float nearest, float farthest) {
  const std::size_t count = trails.size();
  std::vector<glm::vec3>& places = trails.places;
  const std::vector<glm::vec3> first = places;
  const auto next_of = [&](std::size_t i) { return static_cast<std::size_t>(trails.next[i]); };
  std::vector<float> pull(count), closest(count);
  std::vector<std::uint8_t> moves(count, 0);
  std::vector<glm::vec3> force(count), before;
  for (std::size_t i = 0; i < count; ++i)
    pull[i] = power(static_cast<float>(trails.energy[i] / trails.energy[0]), cost);
  // Places that lead to the target are not moved.
  for (std::size_t i = 1; i < count; ++i) moves[next_of(i)] = trails.next[next_of(i)] > 0;
  for (int pass = 0; pass < passes; ++pass) {
    // Forces of all pieces on their ends, and the length of the shortest piece at each place.
    force.assign(count, glm::vec3(0));
    closest.assign(count, std::numeric_limits<float>::max());
    for (std::size_t i = 1; i < count; ++i) {
      const std::size_t next = next_of(i);
      const glm::vec3 way = places[next] - places[i];
      const float length = glm::length(way);
      closest[i] = std::min(closest[i], length);
      closest[next] = std::min(closest[next], length);
      if (!(length > 0)) continue;
      force[i] += (pull[i] / length) * way;
      force[next] -= (pull[i] / length) * way;
    }
    // Moves places along their forces, within both limits.
    before = places;
    for (std::size_t i = 1; i < count; ++i) {
      if (!moves[i] || !(closest[i] > nearest)) continue;
      const glm::vec3 drawn = force[i] / (2 * pull[i]);
      const float share = most / std::max(glm::length(drawn), most);
      const glm::vec3 off = places[i] + share * (closest[i] - nearest) * drawn - first[i];
      places[i] = first[i] + off * std::min(1.0f, farthest / std::max(glm::length(off), farthest));
    }
    take_back_hidden(trails, before, guide);
  }
}

}  // namespace panicle::particles
