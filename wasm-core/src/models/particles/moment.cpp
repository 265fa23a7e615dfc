#include "models/particles/moment.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace panicle::particles {

// A trail is the way that a particle has gone, from its start to the target; the energy of a place is the sum over all
// particles that pass it.

namespace {

// The part of a step that some particle must move for the step to be visible; sampling a quarter into each step then
// shows it.
constexpr float seen = 0.5f;

}  // namespace

// The trails as they are at a moment, in steps from the start: places not yet reached are dropped, and each particle on
// its way ends its trail where it is now. `stride` is the way in a step.
Trails at_moment(const Trails& trails, float moment, float stride) {
  const std::size_t count = trails.size();
  if (count == 0 || moment >= static_cast<float>(trails.born[0])) return trails;
  std::vector<double> own_energy = trails.energy;
  for (std::size_t i = 1; i < count; ++i) own_energy[static_cast<std::size_t>(trails.next[i])] -= trails.energy[i];
  own_energy[0] = 0;
  // Where several particles have met at this very moment, the place is empty before one of them has come.
  std::vector<std::uint8_t> has_arrival(count, 0);
  for (std::size_t i = count; i-- > 1;)
    if ((trails.particle[i] >= 0 || has_arrival[i]) && static_cast<float>(trails.born[i]) < moment &&
        arrival(trails, i, stride) <= moment)
      has_arrival[static_cast<std::size_t>(trails.next[i])] = 1;

  Trails young;
  std::vector<std::int32_t> number(count, -1);
  number[0] = young.add(trails.places[0], -1, 0, trails.born[0], -1);
  for (std::size_t i = 1; i < count; ++i) {
    const auto left_at = static_cast<float>(trails.born[i]);
    const bool start = trails.particle[i] >= 0;
    if (!start && left_at >= moment && !has_arrival[i]) continue;
    const auto next = static_cast<std::size_t>(trails.next[i]);
    const glm::vec3 way = trails.places[next] - trails.places[i];
    const float arrives_at = arrival(trails, i, stride);
    std::int32_t to = -1;
    if (left_at < moment && arrives_at <= moment)
      to = number[next];
    else if (left_at < moment)
      to = young.add(trails.places[i] + ((moment - left_at) / (arrives_at - left_at)) * way, -1, 0, trails.born[i], -1);
    number[i] = young.add(trails.places[i], to, own_energy[i], trails.born[i], trails.particle[i]);
  }
  for (std::size_t i = young.size(); i-- > 1;)
    if (young.next[i] >= 0) young.energy[static_cast<std::size_t>(young.next[i])] += young.energy[i];
  return young;
}

// Lists the steps at which any particle is seen to move.
Timeline::Timeline(std::span<const Trails> crowds, float stride) {
  // By step, the number of particles that begin to be visible less those that cease to be.
  std::vector<std::int32_t> change;
  for (const Trails& trails : crowds)
    for (std::size_t i = 1; i < trails.size(); ++i) {
      if (trails.places[i] == trails.places[static_cast<std::size_t>(trails.next[i])]) continue;
      const std::size_t first = trails.born[i];
      // At its last step a crowd is complete, though smooth trails may be longer than the ways that its particles ran.
      const float until = std::min(arrival(trails, i, stride), static_cast<float>(trails.born[0])) - seen;
      if (!(until > static_cast<float>(first))) continue;
      const auto last = static_cast<std::size_t>(until);
      if (last + 2 > change.size()) change.resize(last + 2, 0);
      ++change[first];
      --change[last + 1];
    }
  std::int32_t moving = 0;
  for (std::size_t step = 0; step < change.size(); ++step) {
    moving += change[step];
    if (moving > 0) lively_.push_back(static_cast<std::uint32_t>(step));
  }
}

// The moment in steps at a share 0 … 1 of the steps in which something visibly moves.
float Timeline::moment(float share) const {
  if (lively_.empty()) return 0;
  const float at = std::clamp(share, 0.0f, 1.0f) * static_cast<float>(lively_.size());
  const std::size_t step = std::min(static_cast<std::size_t>(at), lively_.size() - 1);
  return static_cast<float>(lively_[step]) + (at - static_cast<float>(step));
}

}  // namespace panicle::particles
