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

// How particles move, in spacings of theirs.
struct Motion {
  double energy = 1;
  Rules rules;
};

struct Wood {
  std::vector<Trails> crowds;  // one a target: smooth, and with no more places than they need
  std::vector<Axis> axes;      // one a target
  std::vector<double> all;     // energy that arrives at each in the end
  Tally tally;
  Timeline timeline;
  std::uint32_t unreachable = 0;  // particles that no target can be come to from, and that were left out
};

// Where a plant of wood may be.
struct Rooms {
  const Region& starts;  // ends of twigs
  const Region& outer;   // all of it
};

// Runs the particles to the nearest target, as the crow flies, of those that a way past the obstacles leads to (ties:
// that of the lowest index), those of each for themselves. `habit.ahead` is set by the spacing. `seed`: which way each
// axis sways. Errors: limit, where all together move more often than they may.
Result<Wood> run(std::span<const glm::vec3> starts, std::span<const glm::vec3> targets, float spacing,
                 const Motion& motion, TrunkHabit habit, const TwigHabit& twigs, const Rooms& rooms,
                 const Obstacles& obstacles, std::uint64_t seed, const Limits& limits);

}  // namespace panicle::particles
