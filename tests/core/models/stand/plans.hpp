// What the tests of stands share: plans read and laid in one line.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "models/stand/places.hpp"
#include "models/stand/plan.hpp"
#include "models/stand/surroundings.hpp"

namespace panicle::stand::tests {

template <class Value>
Value sound(Result<Value> result) {
  if (!result) FAIL(result.error().line << ":" << result.error().column << " " << result.error().message);
  return std::move(result.value());
}

struct Laid {
  Plan plan;
  std::vector<Placement> plants;
  std::vector<std::string> notes;
};

inline Laid laid(std::string_view text, std::uint64_t seed = 1, std::uint32_t asked = 0) {
  Laid laid;
  laid.plan = sound(read_plan(text));
  laid.plants = sound(place(laid.plan, Relief(laid.plan.ground, seed), seed, asked, laid.notes));
  return laid;
}

inline glm::vec2 flat(const Placement& plant) { return {plant.at.x, plant.at.z}; }

inline std::vector<std::string> texts() {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(PANICLE_GRAMMARS "/stand")) {
    if (entry.path().extension() != ".stand") continue;
    std::ifstream file(entry.path());
    std::stringstream text;
    text << file.rdbuf();
    found.push_back(text.str());
  }
  return found;
}

}  // namespace panicle::stand::tests
