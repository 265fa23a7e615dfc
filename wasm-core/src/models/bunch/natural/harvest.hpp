// The berries and the flowers on a bunch after swelling.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/bunch/berry/berry_body.hpp"
#include "models/bunch/grown.hpp"
#include "models/bunch/natural/crop.hpp"
#include "models/bunch/natural/settling/bending.hpp"

namespace panicle::bunch {

// The state of each flower: those that did not set fall at an `age` of their own; `size` is the width of berries over
// ripe ones.
std::vector<FlowerOutcome> outcomes_of(const Crop& crop, std::span<const Flower> flowers, std::uint64_t seed, float age,
                                       float size);

// Berries first, in the flowers' order, then the flowers that did not set.
struct Harvest {
  std::vector<Berry> berries;          // metres
  std::vector<BerryBody> bodies;       // the same in millimetres
  std::vector<std::uint32_t> flowers;  // their flowers
  std::vector<Thinned> thinned;        // lost berries, then fallen flowers; metres
};

// `ripe_width` is a mean ripe berry's, in millimetres.
Harvest harvest(const Crop& crop, const Sprout& sprout, const Hanging& hanging, std::span<const FlowerOutcome> outcomes,
                const BentSkeleton& bent, float size, float ripe_width);

}  // namespace panicle::bunch
