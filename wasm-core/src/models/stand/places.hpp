// Where what grows stands: a plan and a seed → placements. What is drawn belongs to the seed, the layer and the place,
// never to how many came before, so that one plant is the same whatever is asked of others.
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
  std::int32_t row = 0, place = 0;  // of a layer in rows: which, and where in it, from the middle
  std::uint32_t kind = 0;           // all layers' kinds in the order of the text
  std::uint32_t seed = 0;
  std::int32_t parent = -1;  // the placement that bears it
  glm::vec3 at{0};
  float scale = 1;
  float turn = 0;               // of its x axis, degrees from +x to +z
  std::vector<float> settings;  // what was drawn; NaN for words
};

// Spots of one layer on the level ground, and how many of those that were wanted found none.
struct Spots {
  std::vector<glm::vec2> at;
  std::vector<glm::ivec2> row;  // of those in rows: which, and where in it, from the middle
  std::uint32_t missing = 0;
};
// Of the strip that a layer keeps to, the middle's z, metres.
float middle_of(const Layer& layer, const Ground& ground);
Spots spots_of(const Layer& layer, std::uint32_t count, const Ground& ground, std::uint64_t seed, std::uint32_t place);

// `requested`: how many plants in place of what the text says, those that are borne not counted; 0: as it says.
// Error: limit.
Result<std::vector<Placement>> place(const Plan& plan, const Relief& relief, std::uint64_t seed, std::uint32_t requested,
                                     std::vector<std::string>& notes);

}  // namespace panicle::stand
