#include "models/particles/wood.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "foundation/random.hpp"
#include "models/particles/crowd.hpp"
#include "models/particles/forks.hpp"
#include "models/particles/gather.hpp"
#include "models/particles/polish.hpp"
#include "models/particles/refusals.hpp"

namespace panicle::particles {
namespace {

// How far a trail may be off where places are left out, in spacings, and of what it keeps clear of obstacles.
constexpr float tolerance = 0.08f, within_margin = 0.8f;
// Branches have no neighbours that keep them from being drawn straight.
constexpr float smoothing = 1.5f;
// Closer than this to the axis, trails are one, in spacings.
constexpr float trunk = 0.35f;
// As near to each other come forks, and so far they go to stand narrower, in spacings.
constexpr float apart = 0.05f, shift = 0.45f;
// How far particles look along the axis, in spacings.
constexpr float ahead = 2;

std::size_t nearest(std::span<const glm::vec3> targets, const glm::vec3& p) {
  std::size_t found = 0;
  float best = glm::dot(p - targets[0], p - targets[0]);
  for (std::size_t i = 1; i < targets.size(); ++i) {
    const float square = glm::dot(p - targets[i], p - targets[i]);
    if (!(square < best)) continue;
    best = square;
    found = i;
  }
  return found;
}

}  // namespace

Result<Wood> run(std::span<const glm::vec3> starts, std::span<const glm::vec3> targets, float spacing,
                 const Motion& motion, TrunkHabit habit, const Region& outer, const Obstacles& obstacles,
                 std::uint64_t seed, const Limits& limits) {
  std::vector<std::vector<glm::vec3>> bound(targets.size());
  for (const glm::vec3& start : starts) bound[nearest(targets, start)].push_back(start);
  Rules rules = motion.rules;
  rules.step *= spacing;
  rules.merge *= spacing;
  rules.neighbourhood *= spacing;
  habit.ahead = ahead * spacing;
  Wood wood;
  std::uint64_t moves = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Axis axis(targets[i], habit.height, habit.sway * habit.height, hash_combine(seed, i));
    const Trunk guide(axis, habit, &outer, &obstacles);
    if (!obstacles.empty())
      wood.unreachable += static_cast<std::uint32_t>(
          std::erase_if(bound[i], [&](const glm::vec3& start) { return !guide.reaches(start); }));
    Crowd crowd(bound[i], motion.energy, guide, rules);
    if (!crowd.run(limits.moves - moves)) return still_running(limits);
    moves += crowd.moves();
    Trails trails = gathered(crowd.trails(), axis, guide, trunk * spacing, rules.step);
    smooth(trails, guide, smoothing);
    trails = simplified(trails, std::min(tolerance * spacing, within_margin * obstacles.margin()), true);
    narrow_forks(trails, guide, apart * spacing, shift * spacing);
    wood.crowds.push_back(std::move(trails));
    wood.all.push_back(wood.crowds.back().energy[0]);
    wood.tally.particles += static_cast<std::uint32_t>(bound[i].size());
    wood.tally.merges += crowd.merges();
    wood.tally.steps = std::max(wood.tally.steps, crowd.steps());
    wood.tally.energy += crowd.arrived();
    wood.stragglers += crowd.stragglers();
  }
  return wood;
}

}  // namespace panicle::particles
