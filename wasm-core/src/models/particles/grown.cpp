#include "models/particles/grown.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "models/particles/extent.hpp"
#include "models/particles/moment.hpp"
#include "spatial/query_budget.hpp"

namespace panicle::particles {
namespace {

constexpr float margin = 0.1f;          // clearance of ways from obstacles, in spacings
constexpr float least_ball = 0.06f;     // radius of a particle, in spacings
constexpr float ball_widens = 1.6f;     // times its trail's radius
constexpr std::uint32_t unfolding = 5;  // the leaves unfold in one step for this many of the run

// Appends an organ, no mesh yet, for each particle on its way: a place with or without a trail behind it, and without a
// next.
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

// Notes the number of targets where trails do not leave the boundary. `way`: of particles, −1 down.
void note_on(std::span<const glm::vec3> targets, const Region& outer, float way, std::vector<std::string>& notes) {
  const float end = way < 0 ? outer.low().y : outer.high().y;
  const auto short_of = [&](const glm::vec3& target) { return (target.y - end) * way < 0; };
  const auto count = std::count_if(targets.begin(), targets.end(), short_of);
  if (count > 0)
    notes.push_back(
        (way < 0 ? "Targets above the boundary's lowest place: " : "Targets below the boundary's highest place: ") +
        std::to_string(count) + (way < 0 ? "; what is below them climbs" : "; what is above them goes down") +
        ", out of the boundary where it must.");
}

// The reason that no particle starts.
const char* why_none(const Extent& room, const Region& outer, bool young) {
  if (!(extent_of(outer).size > 0)) return "The boundary holds no room; make it larger, or its profile wider.";
  if (!(room.size > 0)) return "There is no room between the boundaries; make the inner one smaller.";
  if (!(room.filled > 0))
    return "No light comes to where particles could start, or the hormone holds all of them back.";
  if (young) return "At this age there is no particle yet; let it be older.";
  return "No particle found room; ask for more.";
}

}  // namespace

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
    plant.notes.push_back(any ? "Obstacles leave no room for a particle; make them smaller."
                              : why_none(room, outer, habit.growth < 1));

  note_on(habit.motion.rules, plant.notes);
  note_on(targets, outer, habit.trunk.way, plant.notes);
  Result<Wood> wooden = run(starts, targets, spacing, habit.motion, habit.trunk, habit.twigs, {region, outer},
                            obstacles, request.seed, limits);
  if (region.is_exhausted()) return QueryBudget::error();
  if (!wooden) return wooden.error();
  GrownWood grown;
  grown.room = room.size;
  grown.wood = std::move(wooden.value());
  const Wood& wood = grown.wood;
  if (wood.unreachable > 0)
    plant.notes.push_back(std::to_string(wood.unreachable) +
                          " particles have no way past the obstacles and were left out.");
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
