// The skeleton of a bunch: what it is before it has a surface. Lengths are in whatever unit the procedure grows in.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace panicle::bunch {

enum class Kind : std::uint8_t { rachis = 0, axis = 1, end = 2, pedicel = 3 };
enum class State : std::uint8_t { grown = 0, withered = 1 };

// Of the first bunch's string, that drew something, by its place; of what it did not draw there is none.
inline constexpr std::uint32_t no_module = 0xffffffff;

struct Internode {
  std::int32_t parent = -1;  // index of an earlier internode; −1 at the root
  Kind kind = Kind::rachis;
  State state = State::grown;
  std::int32_t axis = -1;  // first-order axis, 0 at the top; −1 for the rachis and what ends it
  glm::vec3 start{0};
  glm::vec3 end{0};
  float radius = 0;      // at the start
  float radius_end = 0;  // at the end
  bool joint = false;    // goes on with its parent: one organ, drawn in several pieces
  std::uint32_t module = no_module;
};

struct Berry {
  glm::vec3 centre{0};
  float radius = 0;               // of the ball of its volume
  glm::vec3 direction{0, -1, 0};  // unit, from the pedicel towards the tip scar
  std::int32_t parent = -1;       // index of its pedicel
  std::uint32_t id = 0;           // below 2^30; of its pedicel's place in the derivation, the same while handles move
  std::uint32_t module = no_module;
};

}  // namespace panicle::bunch
