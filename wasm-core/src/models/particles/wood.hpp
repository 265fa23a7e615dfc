// Trails of all targets: particles that go to the nearest of several targets that they can reach, and the processing of
// their trails.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "models/particles/moment.hpp"
#include "models/particles/obstacles.hpp"
#include "models/particles/rules.hpp"
#include "models/particles/trail_plant.hpp"
#include "models/particles/trunk.hpp"
#include "models/particles/twig_shape.hpp"
#include "spatial/region.hpp"

namespace panicle::particles {

// The motion of particles, in spacings.
struct Motion {
  double energy = 1;
  Rules rules;
};

struct Wood {
  std::vector<Trails> crowds;  // one a target: smoothed and simplified
  std::vector<Axis> axes;      // one a target
  std::vector<double> all;     // energy that arrives at each in the end
  RunTotals tally;
  Timeline timeline;
  std::uint32_t unreachable = 0;  // particles that can reach no target, and are left out
};

// The regions of a woody plant.
struct WoodRegions {
  const Region& starts;  // ends of twigs
  const Region& outer;   // all of it
};

// Runs the particles of each target by themselves. Each goes to the nearest target, as the crow flies, of those that it
// can reach past the obstacles (ties: that of the lowest index). `habit.ahead` is set by the spacing. `seed`: of the
// axes' sway. Errors: limit, if all together exceed the limit of moves.
Result<Wood> run(std::span<const glm::vec3> starts, std::span<const glm::vec3> targets, float spacing,
                 const Motion& motion, TrunkHabit habit, const TwigHabit& twigs, const WoodRegions& rooms,
                 const Obstacles& obstacles, std::uint64_t seed, const Limits& limits);

}  // namespace panicle::particles
