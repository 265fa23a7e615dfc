// How particles move and meet. Lengths are in the unit of the shape that they are in.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "models/particles/messages.generated.hpp"

namespace panicle::particles {

struct Rules {
  float step = 0;           // s: how far a particle moves at most
  float merge = 0;          // r: closer than this, two become one
  float neighbourhood = 0;  // distance beyond which neighbours are ignored; 0: no limit
  float pull = 0.75f;       // w: weight of a particle's neighbour; 1 as much as its target
  // whether every move is as long as the step (section 2.1), not shorter the more the two pulls differ
  bool printed = false;
  float join = 0;  // closer than this to an older trail ahead, a particle ends in it; 0: trails may cross
};

// Half the distance by which two particles that aim at each other approach in a step: a whole step in the paper's
// printed rule, else the step times the share of the neighbour's pull.
inline float approach(const Rules& rules) {
  return rules.printed ? rules.step : rules.step * rules.pull / (1 + rules.pull);
}

// The least merge radius with which two that move towards each other cannot jump past each other endlessly.
inline float least_merge(const Rules& rules) { return 2 * approach(rules); }

// Adds a note if rules, in spacings, have a merge radius that is less than that.
inline void note_on(const Rules& rules, std::vector<std::string>& notes) {
  const float least = least_merge(rules);
  if (rules.merge < least)
    notes.push_back(message(messages::particles::merge_radius_raised, static_cast<int>(100 * least + 0.5f)));
}

}  // namespace panicle::particles
