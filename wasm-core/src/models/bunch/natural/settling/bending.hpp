// The skeleton as the berries leave it: bent, as stout as its age, less what has fallen.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/bunch/natural/flowers.hpp"
#include "models/bunch/natural/hanging.hpp"

namespace panicle::bunch {

// What has become of a flower. Where several share a stalk, it goes by the last of these that one of them has.
enum class FlowerState : std::uint8_t {
  fallen,  // and its stalk with it
  stub,    // its berry was lost, its stalk is withered
  flower,  // it hangs there and will not set
  berry,
};

struct FlowerOutcome {
  FlowerState state = FlowerState::fallen;
  glm::vec3 seat{0};  // of a berry: where its stalk ends, millimetres
};

struct Bent {
  std::vector<Internode> internodes;   // what is left, parents first; metres
  std::vector<std::int32_t> place_of;  // per internode of the sprout: where it is in `internodes`; −1 where it fell
};

// `outcomes` are the flowers', `ends` those of the hanging's branches once all has swollen (millimetres), `size` the
// berries' width now over the ripe one. Stems that bear nothing any more fall, but for the rachis and what never bore a
// flower: that is as the text has it.
Bent bend_skeleton(std::span<const Internode> internodes, std::span<const Flower> flowers, const Hanging& hanging,
                   std::span<const FlowerOutcome> outcomes, std::span<const glm::vec3> ends, float size);

}  // namespace panicle::bunch
