// Helpers for tests of stands: read and place a plan in one line.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

#include "grammar_files.hpp"
#include "models/stand/places.hpp"
#include "models/stand/plan.hpp"
#include "models/stand/surroundings.hpp"
#include "sound.hpp"

namespace panicle::stand::tests {

using panicle::tests::sound;

struct PlacedStand {
  Plan plan;
  std::vector<Placement> plants;
  std::vector<std::string> notes;
};

inline PlacedStand placed(std::string_view text, std::uint64_t seed = 1, std::uint32_t requested = 0) {
  PlacedStand placed;
  placed.plan = sound(read_plan(text));
  placed.plants = sound(place(placed.plan, Relief(placed.plan.ground, seed), seed, requested, placed.notes));
  return placed;
}

inline glm::vec2 flat(const Placement& plant) { return {plant.at.x, plant.at.z}; }

inline std::vector<std::string> texts() {
  std::vector<std::string> found;
  for (const auto& path : panicle::tests::grammar_files("stand")) found.push_back(panicle::tests::content(path));
  return found;
}

}  // namespace panicle::stand::tests
