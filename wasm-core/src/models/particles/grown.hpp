// From a volume to a plant: the shared part of tree and root.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "models/particles/scatter.hpp"
#include "models/particles/space_request.hpp"
#include "models/particles/trail_plant.hpp"
#include "models/particles/wood.hpp"
#include "plant/plant.hpp"

namespace panicle::particles {

struct SpaceHabit {
  std::uint32_t count = 1000;
  Pattern pattern = Pattern::blue;
  Motion motion;
  Girth girth;
  TrunkHabit trunk;
  TwigHabit twigs;
  float age = 1;        // 0 … 1
  bool running = true;  // effect of age: whether particles run, or the volume grows
  bool leafy = false;   // whether there are leaves to unfold once particles have arrived
  float growth = 1;     // size of the volume over the full-grown one

  // The number of particles in the volume at this growth, at the density of the full-grown one.
  std::uint32_t young() const {
    return static_cast<std::uint32_t>(static_cast<float>(count) * growth * growth * growth + 0.5f);
  }
};

inline constexpr float youngest = 0.02f;  // size of the volume at age 0

// Reads the parameters that tables of both models have under the same keys. `Keys`: the model's enumeration of
// parameters.
template <class Keys, class Values>
SpaceHabit space_habit(const Values& values) {
  SpaceHabit habit;
  habit.count = values.whole(Keys::particles);
  // Where points are removed again, blue noise would be lost, and its cost wasted.
  constexpr std::array patterns{Pattern::uniform, Pattern::jittered, Pattern::blue, Pattern::jittered};
  habit.pattern = patterns[values.whole(Keys::pattern)];
  habit.motion = {static_cast<double>(values[Keys::energy]),
                  {.step = values[Keys::step],
                   .merge = values[Keys::merge],
                   .neighbourhood = values[Keys::neighbourhood],
                   .pull = values[Keys::pull],
                   .printed = values.whole(Keys::rule) == 1}};
  habit.age = values[Keys::age] / 100;
  habit.running = values.whole(Keys::life) == 0;
  if (!habit.running) habit.growth = std::max(habit.age, youngest);
  constexpr std::array laws{WidthLaw::linear, WidthLaw::square_root, WidthLaw::power, WidthLaw::power};
  const std::uint32_t law = values.whole(Keys::law);
  habit.girth = {laws[law], law == 2 ? 1.0f / 3 : values[Keys::exponent], 0.005f * habit.growth * values[Keys::girth],
                 0.0005f * values[Keys::twig]};
  habit.trunk.slant = values[Keys::slant];
  habit.trunk.sway = values[Keys::sway];
  habit.twigs.crook = values[Keys::crook];
  // Particles run from the tips to the target, so the bend of their way is opposite to the bend of branches.
  habit.trunk.bend = {0, values[Keys::gravitropism], 0};
  return habit;
}

struct GrownWood {
  float room = 0;  // volume of the region where particles may start
  Wood wood;
  std::vector<Trails> trails;                      // of each target, as they are now
  std::vector<std::vector<std::int32_t>> numbers;  // of each place its segment, −1 for none
  float unfolded = 1;                              // how far the leaves have unfolded, 0 … 1
};

// Scatters, runs, and adds to the plant its segments, columns, counts and notes; particles on their way as organs of
// tag `traveller`. No particle starts in an obstacle; ways round obstacles stay between `floor` and `ceiling`. Errors:
// those of `run`.
Result<GrownWood> grow_wood(Plant& plant, const Region& region, const Region& outer, std::span<const glm::vec3> targets,
                            const SpaceHabit& habit, const SpaceRequest& request, float floor, float ceiling,
                            std::uint32_t traveller, const Limits& limits);

}  // namespace panicle::particles
