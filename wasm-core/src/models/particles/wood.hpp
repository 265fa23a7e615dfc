// Trails of a whole stand: particles that go to the nearest of several targets, and what becomes of their trails.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "models/particles/obstacles.hpp"
#include "models/particles/region.hpp"
#include "models/particles/rules.hpp"
#include "models/particles/trail_plant.hpp"
#include "models/particles/trunk.hpp"

namespace panicle::particles {

// How particles move, in spacings of theirs.
struct Motion {
  double energy = 1;
  Rules rules;
};

struct Wood {
  std::vector<Trails> crowds;  // one a target: smooth, and with no more places than they need
  std::vector<double> all;     // what arrives at each in the end
  Tally tally;
  std::uint32_t stragglers = 0;   // that had to be led to their target
  std::uint32_t unreachable = 0;  // that have no way past the obstacles, and were left out
};

// Runs the particles to the nearest target (ties: that of the lowest index), those of each for themselves.
// `habit.ahead` is set by the spacing. `seed`: which way each axis sways. Errors: limit, where all together move more
// often than they may.
Result<Wood> run(std::span<const glm::vec3> starts, std::span<const glm::vec3> targets, float spacing,
                 const Motion& motion, TrunkHabit habit, const Region& outer, const Obstacles& obstacles,
                 std::uint64_t seed, const Limits& limits);

}  // namespace panicle::particles
