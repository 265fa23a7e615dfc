#include "models/particles/wood.hpp"

#include <algorithm>
#include <deque>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "foundation/random.hpp"
#include "models/particles/forks.hpp"
#include "models/particles/gather.hpp"
#include "models/particles/particle_system.hpp"
#include "models/particles/polish.hpp"
#include "models/particles/refusals.hpp"

namespace panicle::particles {

// A trail is the way that a particle has gone, from its start to the target; the energy of a place is the sum over all
// particles that pass it.

namespace {

// The tolerance of simplification, in spacings, and its share of the margin around obstacles.
constexpr float tolerance = 0.08f, within_margin = 0.8f;
// Smoothing of branches, more than of veins: no neighbours limit it.
constexpr float smoothing = 1.5f;
// Distance from the axis, in spacings, within which trails are united.
constexpr float trunk = 0.35f;
// Least distance of forks, and their largest move, in spacings.
constexpr float apart = 0.05f, shift = 0.45f;
// Looking distance of particles along the axis, in spacings.
constexpr float ahead = 2;

// In spacings: the length of pieces of hanging twigs, and of the arc in which they turn down; the length of pieces of
// wandering branches, and of the noise that they wander by.
constexpr float hanging_piece = 0.4f, arc = 1.5f, wandering_piece = 0.65f, billow = 1.3f;

// The number of tips: places where a particle starts.
double tips_of(const Trails& trails) {
  return static_cast<double>(std::count_if(trails.particle.begin(), trails.particle.end(),
                                           [](std::int32_t particle) { return particle >= 0; }));
}

// The nearest target that a particle at `p` can reach (ties: that of the lowest index); none if it can reach none.
std::optional<std::size_t> nearest_target(const std::deque<Trunk>& guides, const glm::vec3& p) {
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

// Sizes that the shaping of twigs depends on: the mean distance of starts, the way in a step, and the seed.
struct Scale {
  float spacing, stride;
  std::uint64_t seed;
};

// Lets twigs hang and branches wander, as the habit requires. Straight pieces are divided first, those of twigs alone
// if nothing else moves.
Trails shaped(const Trails& trails, const Guide& guide, const Region& outer, const Region& room, const TwigHabit& habit,
              const Scale& scale) {
  const double total_energy = trails.energy[0], tip_energy = total_energy / tips_of(trails);
  const double least = habit.weep > 0 ? 0 : 0.999 * tip_energy * static_cast<double>(habit.crook_tips);
  const double most = habit.crook > 0 ? 2 * total_energy : tip_energy * static_cast<double>(habit.weep_tips);
  const float piece = habit.weep > 0 ? hanging_piece : wandering_piece;
  Trails result = divided(trails, piece * scale.spacing, least, most, scale.stride);
  hang_twigs(result, guide, outer, room, habit, arc * scale.spacing);
  wander_branches(result, guide, outer, habit.crook * scale.spacing, billow * scale.spacing, scale.seed);
  return simplified(result, tolerance * scale.spacing, true);
}

}  // namespace

// Assigns the starts to the nearest targets that they can reach, runs the particles of each target, and smooths and
// shapes their trails. `spacing`, the mean distance of starts, scales all rules. Fails when the limits' moves are used
// up.
Result<Wood> run(std::span<const glm::vec3> starts, std::span<const glm::vec3> targets, float spacing,
                 const Motion& motion, TrunkHabit habit, const TwigHabit& twigs, const WoodRegions& rooms,
                 const Obstacles& obstacles, std::uint64_t seed, const Limits& limits) {
  Rules rules = motion.rules;
  rules.step *= spacing;
  rules.merge *= spacing;
  rules.neighbourhood *= spacing;
  habit.ahead = ahead * spacing;
  std::vector<Axis> axes;
  std::deque<Trunk> guides;  // a deque, for stable addresses
  std::uint64_t moves = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    axes.emplace_back(targets[i], habit.height, habit.sway * habit.height, hash_combine(seed, i));
    guides.emplace_back(axes[i], habit, &rooms.outer, &obstacles);
  }
  Wood wood;
  std::vector<std::vector<glm::vec3>> bound(targets.size());
  for (const glm::vec3& start : starts)
    if (const auto target = nearest_target(guides, start))
      bound[*target].push_back(start);
    else
      ++wood.unreachable;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Trunk& guide = guides[i];
    ParticleSystem crowd(bound[i], motion.energy, guide, rules);
    if (!crowd.run(limits.moves - moves)) return still_running(limits);
    moves += crowd.moves();
    Trails trails = gathered(crowd.trails(), axes[i], guide, trunk * spacing, rules.step);
    smooth(trails, guide, smoothing);
    trails = simplified(trails, std::min(tolerance * spacing, within_margin * obstacles.margin()), true);
    narrow_forks(trails, guide, apart * spacing, shift * spacing);
    if (twigs.shapes())
      trails = shaped(trails, guide, rooms.outer, rooms.starts, twigs, {spacing, rules.step, hash_combine(seed, i)});
    wood.crowds.push_back(std::move(trails));
    wood.axes.push_back(axes[i]);
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
