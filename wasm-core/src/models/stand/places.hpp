// Placement of plants: a plan and a seed → placements. Random values depend on the seed, the layer and the place, never
// on the number of plants before, so that one plant is the same however many others are requested.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "foundation/result.hpp"
#include "models/stand/ground.hpp"
#include "models/stand/plan.hpp"

namespace panicle::stand {

struct Placement {
  std::uint32_t layer = 0;
  std::int32_t row = 0, place = 0;  // of a layer in rows: the row, and the place in it, from the middle
  std::uint32_t kind = 0;           // index of its kind; kinds of all layers, in the order of the plan
  std::uint32_t seed = 0;
  std::int32_t parent = -1;  // index of the placement that it is attached to; −1 on the ground
  glm::vec3 at{0};
  float scale = 1;
  float turn = 0;               // of its x axis, degrees from +x to +z
  std::vector<float> settings;  // drawn values; NaN for words
};

// Spots of one layer on the level ground, and the number of plants that found none.
struct Spots {
  std::vector<glm::vec2> at;
  std::vector<glm::ivec2> row;  // of spots in rows: the row, and the place in it, from the middle
  std::uint32_t missing = 0;
};
// z of the middle of a layer's strip, metres.
float middle_of(const Layer& layer, const Ground& ground);
Spots spots_of(const Layer& layer, std::uint32_t count, const Ground& ground, std::uint64_t seed, std::uint32_t place);

// Places the plants of a plan. `requested`: number of plants on the ground in place of the plan's; 0: the plan's.
// Error: limit.
Result<std::vector<Placement>> place(const Plan& plan, const Relief& relief, std::uint64_t seed,
                                     std::uint32_t requested, std::vector<std::string>& notes);

}  // namespace panicle::stand
