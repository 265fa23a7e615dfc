#include "models/particles/grown.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "models/particles/extent.hpp"
#include "models/particles/messages.generated.hpp"
#include "models/particles/moment.hpp"
#include "spatial/query_budget.hpp"

namespace panicle::particles {

// A trail is the way that a particle has gone, from its start to the target.

namespace {

constexpr float margin = 0.1f;          // clearance of ways from obstacles, in spacings
constexpr float least_ball = 0.06f;     // radius of a particle, in spacings
constexpr float ball_widens = 1.6f;     // times its trail's radius
constexpr std::uint32_t unfolding = 5;  // the leaves unfold in one step for this many of the run

// Appends a ball as an organ for each particle that is still on its way: such a place has no next. `all` is the energy
// of all particles, which with `girth` gives the trail's radius.
void add_travellers(Plant& plant, const Trails& trails, double all, const Girth& girth, float least_radius,
                    std::uint32_t tag) {
  for (std::size_t i = 1; i < trails.size(); ++i) {
    if (trails.next[i] >= 0) continue;
    Organ ball;
    ball.tag = tag;
    ball.position = trails.places[i];
    ball.scale = std::max(ball_widens * radius_of(girth, trails.energy[i], all), least_radius);
    plant.organs.push_back(ball);
  }
}

// The clearance of ways from obstacles: at most half the distance of the nearest obstacle from a target, so that there
// are ways between them.
float clearance(const SpaceRequest& request, std::span<const glm::vec3> targets, float spacing) {
  float clear = margin * spacing;
  for (const std::span<const Box> some : {std::span(request.obstacles), std::span(request.rounds)})
    for (const Box& box : some)
      for (const glm::vec3& target : targets)
        if (const float away = glm::distance(target, glm::clamp(target, box.low, box.high)); away > 0)
          clear = std::min(clear, 0.5f * away);
  return clear;
}

// Adds a note with the number of targets that particles reach before they leave the boundary, so that there is no free
// trunk. `way` is the vertical direction of the particles: −1 down, 1 up.
void note_targets_inside(std::span<const glm::vec3> targets, const Region& outer, float way,
                         std::vector<std::string>& notes) {
  const float end = way < 0 ? outer.low().y : outer.high().y;
  const auto short_of = [&](const glm::vec3& target) { return (target.y - end) * way < 0; };
  const auto count = std::count_if(targets.begin(), targets.end(), short_of);
  if (count > 0)
    notes.push_back(message(
        way < 0 ? messages::particles::targets_above_boundary : messages::particles::targets_below_boundary, count));
}

// The message why no particle starts. `room` is measured between the boundaries, `outer` is the outer boundary, `young`
// a plant that is not grown up.
const MessageCode<0>& why_none(const Extent& room, const Region& outer, bool young) {
  if (!(extent_of(outer).size > 0)) return messages::particles::boundary_without_room;
  if (!(room.size > 0)) return messages::particles::no_room_between_boundaries;
  if (!(room.filled > 0)) return messages::particles::no_place_to_start;
  return young ? messages::particles::no_particle_yet : messages::particles::no_particle_fits;
}

}  // namespace

// Grows wood: scatters particles, lets them run to the targets, and adds the trails at the habit's age as segments of
// the plant. `floor` and `ceiling` bound the ways around obstacles; `traveller` is the tag of particles on their way.
Result<GrownWood> grow_wood(Plant& plant, const Region& region, const Region& outer, std::span<const glm::vec3> targets,
                            const SpaceHabit& habit, const SpaceRequest& request, float floor, float ceiling,
                            std::uint32_t traveller, const Limits& limits) {
  // A young volume has the grown one's spacing, and so fewer particles.
  auto [starts, spacing, room] = scatter_all(region, habit.pattern, habit.count, request.seed, habit.growth);
  if (region.is_exhausted()) return QueryBudget::error();
  const float step = habit.motion.rules.step * spacing;
  const Obstacles obstacles(request.obstacles, request.rounds, clearance(request, targets, spacing), floor, ceiling);
  const bool any = !starts.empty();
  std::erase_if(starts, [&](const glm::vec3& start) { return obstacles.contains(start); });
  if (starts.empty())
    plant.notes.push_back(
        message(any ? messages::particles::obstacles_fill_boundary : why_none(room, outer, habit.growth < 1)));

  note_on(habit.motion.rules, plant.notes);
  note_targets_inside(targets, outer, habit.trunk.way, plant.notes);
  Result<Wood> wooden = run(starts, targets, spacing, habit.motion, habit.trunk, habit.twigs, {region, outer},
                            obstacles, request.seed, limits);
  if (region.is_exhausted()) return QueryBudget::error();
  if (!wooden) return wooden.error();
  GrownWood grown;
  grown.room = room.size;
  grown.wood = std::move(wooden.value());
  const Wood& wood = grown.wood;
  if (wood.unreachable > 0) plant.notes.push_back(message(messages::particles::particles_left_out, wood.unreachable));
  // First particles run, then the leaves unfold, in steps as long.
  const std::uint32_t steps = wood.timeline.steps(), further = habit.leafy ? steps / unfolding + 1 : 0;
  grown.wood.tally.steps = steps + further;
  const float at =
      habit.running ? habit.age * static_cast<float>(steps + further) : static_cast<float>(steps + further);
  const bool running = at < static_cast<float>(steps);
  if (further > 0)
    grown.unfolded = std::clamp((at - static_cast<float>(steps)) / static_cast<float>(further), 0.0f, 1.0f);
  const float moment = running ? wood.timeline.moment(at / static_cast<float>(steps)) : 0;
  for (const Trails& trails : wood.crowds) grown.trails.push_back(running ? at_moment(trails, moment, step) : trails);
  grown.numbers = add_trails(plant, grown.trails, wood.all, habit.girth, {}, wood.tally, 0);
  for (std::size_t c = 0; running && c < targets.size(); ++c)
    add_travellers(plant, grown.trails[c], wood.all[c], habit.girth, least_ball * spacing, traveller);
  return grown;
}

}  // namespace panicle::particles
