#include "models/particles/twig_shape.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "foundation/easing.hpp"
#include "models/particles/polish.hpp"
#include "models/particles/value_noise.hpp"

namespace panicle::particles {

// A trail is the way that a particle has gone, from its start to the target; the energy of a place is the sum over all
// particles that pass it.

namespace {

// Twigs turn less where their ends have no room; each pass reduces the turn.
constexpr int passes = 3;

// Rotates a direction by a share of the way to straight down; a vertical direction has no side to fall to.
glm::vec3 turned_down(const glm::vec3& way, float share) {
  if (!(way.x * way.x + way.z * way.z > 1e-6f)) return way;
  const glm::vec3 turned = (1 - share) * way - glm::vec3(0, share, 0);
  return turned / glm::length(turned);
}

}  // namespace

// Lets the ends of twigs hang down: each piece turns down by `weep`, more the fewer tips it carries and the farther out
// it is, up to the length `arc`. Twigs whose ends leave `room` or `outer` turn less.
void hang_twigs(Trails& trails, const Guide& guide, const Region& outer, const Region& room, const TwigHabit& habit,
                float arc) {
  const std::size_t count = trails.size();
  if (!(habit.weep > 0) || count < 2) return;
  const std::vector<glm::vec3> before = trails.places;
  std::vector<glm::vec3>& places = trails.places;
  double tip = trails.energy[0];
  for (std::size_t i = 1; i < count; ++i)
    if (trails.particle[i] >= 0) tip = std::min(tip, trails.energy[i]);
  // The number of tips beyond each place, and the share of its turn that is left.
  std::vector<float> tips(count), run(count, 0), left(count, 1), fitting(count);
  for (std::size_t i = 0; i < count; ++i) tips[i] = static_cast<float>(trails.energy[i] / tip);
  for (int pass = 0; pass < passes; ++pass) {
    const bool last = pass + 1 == passes;
    fitting.assign(count, 0);
    for (std::size_t i = 1; i < count; ++i) {
      if (!(tips[i] < habit.weep_tips)) continue;
      const auto next = static_cast<std::size_t>(trails.next[i]);
      const glm::vec3 way = before[i] - before[next];
      const float length = glm::length(way);
      run[i] = run[next] + length;
      const float turn = left[i] * habit.weep * (1 - tips[i] / habit.weep_tips) * smooth_step(0, arc, run[i]);
      places[i] = places[next] + (turn > 0 && length > 0 ? length * turned_down(way / length, turn) : way);
      const bool start = trails.particle[i] >= 0;
      const bool fits = guide.open(places[i]) && (start ? room.has_room(places[i]) : outer.contains(places[i]));
      if (start) fitting[i] = fits;
      if (last && !fits && (start || outer.contains(before[i]))) places[i] = before[i];
    }
    if (last) break;
    for (std::size_t i = count; i-- > 1;) {
      fitting[static_cast<std::size_t>(trails.next[i])] += fitting[i];
      left[i] *= fitting[i] / tips[i];
    }
  }
  take_back_hidden(trails, before, guide);
}

// Moves places by noise, up to `by` and with a wavelength of about `over`, so that branches wander; thin ones more.
void wander_branches(Trails& trails, const Guide& guide, const Region& outer, float by, float over,
                     std::uint64_t seed) {
  const std::size_t count = trails.size();
  if (!(by > 0) || count < 2) return;
  const std::vector<glm::vec3> before = trails.places;
  glm::vec3 low = before[0], high = low;
  for (const glm::vec3& p : before) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const ValueNoise x(low, high, over, seed), y(low, high, over, seed + 1), z(low, high, over, seed + 2);
  for (std::size_t i = 1; i < count; ++i) {
    if (trails.particle[i] >= 0 || trails.next[i] == 0) continue;
    const glm::vec3& p = before[i];
    const float free = 1 - static_cast<float>(std::sqrt(trails.energy[i] / trails.energy[0]));
    const glm::vec3 to = p + by * free * (2.0f * glm::vec3(x.at(p), y.at(p), z.at(p)) - 1.0f);
    if (outer.contains(to) ? guide.open(to) : !outer.contains(p) && guide.passes(p, to)) trails.places[i] = to;
  }
  take_back_hidden(trails, before, guide);
}

}  // namespace panicle::particles
