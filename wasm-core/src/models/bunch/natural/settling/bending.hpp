// The skeleton bent by its berries, as thick as its age, without the fallen parts.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/bunch/natural/flowers.hpp"
#include "models/bunch/natural/hanging.hpp"

namespace panicle::bunch {

// The state of a flower. Flowers that share a stalk share the last of these states that one of them has.
enum class FlowerState : std::uint8_t {
  fallen,  // and its stalk with it
  stub,    // its berry was lost, the stalk is withered
  flower,  // not fallen yet, and will not set
  berry,
};

struct FlowerOutcome {
  FlowerState state = FlowerState::fallen;
  glm::vec3 seat{0};  // of a berry: where its stalk ends, millimetres
};

struct BentSkeleton {
  std::vector<Internode> internodes;   // those left, parents first; metres
  std::vector<std::int32_t> place_of;  // per internode of the sprout: where it is in `internodes`; −1 where it fell
};

// Moves the stems to where the swollen berries hang, shortens stubs, and drops stems that have lost all their flowers.
// `outcomes` are the flowers', `ends` those of the hanging's branches after all berries have swollen (millimetres),
// `size` the berries' width now over the ripe one. Stems that have lost all their flowers fall, except the rachis;
// stems that never had a flower stay, as the text draws them.
BentSkeleton bend_skeleton(std::span<const Internode> internodes, std::span<const Flower> flowers,
                           const Hanging& hanging, std::span<const FlowerOutcome> outcomes,
                           std::span<const glm::vec3> ends, float size);

}  // namespace panicle::bunch
