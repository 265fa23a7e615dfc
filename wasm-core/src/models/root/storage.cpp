#include "models/root/storage.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/easing.hpp"
#include "foundation/mathematics.hpp"

namespace panicle::particles::root {
namespace {

constexpr float taper = 0.75f;  // the power of the rest of the way: below 1 it is blunt
// A root thicker than this multiple of its radius by energy is completely on its axis.
constexpr float straight = 2;

}  // namespace

// The radius of a storage root at a depth below its collar; 0 below its reach.
float storage_radius(const StorageHabit& habit, float below) {
  if (!(habit.reach > 0) || below >= habit.reach) return 0;
  return habit.radius * power(1 - std::max(below, 0.0f) / habit.reach, taper);
}

// Thickens the heaviest root of a plant, from its collar down as far as it would be thicker than it is, and moves it
// towards its axis. `target`: index of the plant.
void swell(std::vector<Segment>& segments, const GrownWood& grown, std::size_t target, const StorageHabit& habit) {
  const Trails& trails = grown.trails[target];
  const std::vector<std::int32_t>& numbers = grown.numbers[target];
  const double all = grown.wood.all[target];
  if (trails.size() < 2 || !(all > 0)) return;
  // A young root is thin.
  const auto arrived = static_cast<float>(std::sqrt(trails.energy[0] / all));
  const float collar = trails.places[0].y;
  const Axis& axis = grown.wood.axes[target];
  std::vector<std::size_t> heaviest(trails.size(), 0);
  for (std::size_t i = 1; i < trails.size(); ++i) {
    if (trails.next[i] < 0) continue;
    std::size_t& best = heaviest[static_cast<std::size_t>(trails.next[i])];
    if (best == 0 || trails.energy[i] > trails.energy[best]) best = i;
  }
  for (std::size_t at = heaviest[0]; at != 0; at = heaviest[at]) {
    Segment& segment = segments[static_cast<std::size_t>(numbers[at])];
    const float from = arrived * storage_radius(habit, collar - segment.start.y);
    if (!(from > segment.radius)) break;
    const float to = arrived * storage_radius(habit, collar - segment.end.y);
    const float drawn = smooth_step(1, straight, to / segment.radius_end);
    segment.end += drawn * (axis.at(segment.end.y) - segment.end);
    segment.radius = from;
    segment.radius_end = std::max(to, segment.radius_end);
  }
  for (Segment& segment : segments)
    if (segment.parent >= 0) segment.start = segments[static_cast<std::size_t>(segment.parent)].end;
}

}  // namespace panicle::particles::root
