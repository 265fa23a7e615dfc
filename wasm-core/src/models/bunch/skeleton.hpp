// The skeleton of a bunch, before it has a surface. Lengths are in the unit of the procedure that grows it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "stems/segment.hpp"

namespace panicle::bunch {

enum class Kind : std::uint8_t { rachis = 0, axis = 1, end = 2, pedicel = 3 };
enum class State : std::uint8_t { grown = 0, withered = 1 };

// In place of the index of a module in the first bunch's string, for parts that no module of it drew.
inline constexpr std::uint32_t no_module = 0xffffffff;

// A segment of the skeleton; its tag is unused, and `kind` in its place.
struct Internode : Segment {
  Kind kind = Kind::rachis;
  State state = State::grown;
  std::int32_t axis = -1;  // first-order axis, 0 at the top; −1 for the rachis and its end
  bool joint = false;      // whether it continues its parent: one organ, drawn in several pieces
  std::uint32_t module = no_module;
};

struct Berry {
  glm::vec3 centre{0};
  float radius = 0;               // of the ball of its volume
  glm::vec3 direction{0, -1, 0};  // unit, from the pedicel towards the tip scar
  std::int32_t parent = -1;       // index of its pedicel
  std::uint32_t id = 0;           // below 2^30; from its pedicel's place in the derivation, stable while handles move
  std::uint32_t module = no_module;
};

}  // namespace panicle::bunch
