#include "models/particles/wood.hpp"

#include <algorithm>
#include <deque>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "foundation/random.hpp"
#include "models/particles/crowd.hpp"
#include "models/particles/forks.hpp"
#include "models/particles/gather.hpp"
#include "models/particles/polish.hpp"

namespace panicle::particles {
namespace {

// How far a trail may be off where places are left out, in spacings.
constexpr float tolerance = 0.08f;
// Branches have no neighbours that keep them from being drawn straight.
constexpr float smoothing = 1.5f;
// Closer than this to the axis, trails are one, in spacings.
constexpr float trunk = 0.35f;
// As near to each other come forks, and so far they go to stand narrower, in spacings.
constexpr float apart = 0.05f, shift = 0.45f;
// How far particles look along the axis, in spacings.
constexpr float ahead = 2;

// The nearest target that a particle can come to from `p` (ties: that of the lowest index); none where it can come to
// no one.
std::optional<std::size_t> nearest(const std::deque<Trunk>& guides, const glm::vec3& p) {
  std::optional<std::size_t> found;
  float best = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < guides.size(); ++i) {
    const glm::vec3 way = p - guides[i].target();
    const float square = glm::dot(way, way);
    if (!(square < best) || !guides[i].reaches(p)) continue;
    best = square;
    found = i;
  }
  return found;
}

}  // namespace

Wood run(std::span<const glm::vec3> starts, std::span<const glm::vec3> targets, float spacing, const Motion& motion,
         TrunkHabit habit, const Region& outer, const Obstacles& obstacles, std::uint64_t seed) {
  Rules rules = motion.rules;
  rules.step *= spacing;
  rules.merge *= spacing;
  rules.neighbourhood *= spacing;
  habit.ahead = ahead * spacing;
  std::vector<Axis> axes;
  std::deque<Trunk> guides;  // which stay where they are
  for (std::size_t i = 0; i < targets.size(); ++i) {
    axes.emplace_back(targets[i], habit.height, habit.sway * habit.height, hash_combine(seed, i));
    guides.emplace_back(axes[i], habit, &outer, &obstacles);
  }
  Wood wood;
  std::vector<std::vector<glm::vec3>> bound(targets.size());
  for (const glm::vec3& start : starts)
    if (const auto target = nearest(guides, start))
      bound[*target].push_back(start);
    else
      ++wood.unreachable;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Trunk& guide = guides[i];
    Crowd crowd(bound[i], motion.energy, guide, rules);
    crowd.run();
    Trails trails = gathered(crowd.trails(), axes[i], guide, trunk * spacing, rules.step);
    smooth(trails, guide, smoothing);
    trails = simplified(trails, tolerance * spacing, true);
    narrow_forks(trails, guide, apart * spacing, shift * spacing);
    wood.crowds.push_back(std::move(trails));
    wood.all.push_back(wood.crowds.back().energy[0]);
    wood.tally.particles += static_cast<std::uint32_t>(bound[i].size());
    wood.tally.merges += crowd.merges();
    wood.tally.energy += crowd.arrived();
    wood.tally.stragglers += crowd.stragglers();
  }
  wood.timeline = Timeline(wood.crowds, rules.step);
  wood.tally.steps = wood.timeline.steps();
  return wood;
}

}  // namespace panicle::particles
