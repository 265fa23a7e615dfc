// What hangs on a bunch when all has swollen: berries, and flowers that have not fallen yet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/bunch/berry/berry_body.hpp"
#include "models/bunch/grown.hpp"
#include "models/bunch/natural/crop.hpp"
#include "models/bunch/natural/settling/bending.hpp"

namespace panicle::bunch {

// One a flower: `age` says which of those that did not set have fallen, `size` how wide berries are over ripe ones.
std::vector<FlowerOutcome> outcomes_of(const Crop& crop, std::span<const Flower> flowers, std::uint64_t seed, float age,
                                 float size);

// Berries first, in the flowers' order, then the flowers that did not set.
struct Harvest {
  std::vector<Berry> berries;          // metres
  std::vector<BerryBody> bodies;       // the same in millimetres
  std::vector<std::uint32_t> flowers;  // whose they are
  std::vector<Thinned> thinned;        // who is not there: lost berries, then fallen flowers; metres
};

// `ripe_width` is a mean ripe berry's, in millimetres.
Harvest harvest(const Crop& crop, const Sprout& sprout, const Hanging& hanging, std::span<const FlowerOutcome> outcomes,
                const Bent& bent, float size, float ripe_width);

}  // namespace panicle::bunch
