// Berries swell among each other: contacts, pedicels, stems and gravity solved together, step by step as they grow.
//
// Extended position-based dynamics (Macklin, Müller & Chentanez 2016, XPBD: Position-Based Simulation of Compliant
// Constrained Dynamics, equations 17 and 18) without velocities: growth is slow, so every step starts at rest.
// Constraints are solved one after another in a fixed order, so that results are the same on all machines.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/bunch/grown.hpp"
#include "models/bunch/paper/envelope.hpp"
#include "models/bunch/stance.hpp"

namespace panicle::bunch {

// A stem with berries on it; millimetres. Parents come first.
struct Branch {
  glm::vec3 start{0}, end{0};  // before anything bends
  std::int32_t parent = -1;
  float radius = 0;
  float give = 0;     // 0 … 1: how readily its end moves against its start
  bool sags = false;  // whether it bends under its berries; the rachis does not
};

struct Swelling {
  std::uint32_t branch = 0;               // the branch at whose end the pedicel grows
  glm::vec3 heading{0, -1, 0};            // of the pedicel, unit
  float stalk = 0;                        // full length of the pedicel
  float half_width = 0, half_length = 0;  // ripe
  std::uint32_t bunch = 0;                // index of its outline
  bool taken = false;                     // removed by hand after it has grown
  bool late = false;                      // joins only where others found no room, in the given order
};

// An outline and its stance; millimetres.
struct BunchEnvelope {
  Envelope envelope;
  Stance stance;
};

struct Swollen {
  std::vector<glm::vec3> ends;        // of the branches
  std::vector<glm::vec3> centres;     // of the berries
  std::vector<glm::vec3> directions;  // unit, from the pedicel's foot to the berry's tip
  std::vector<RemovalReason> lost;    // of the berries; 0 for those present, not_set for those that never joined
  SwellingWork work;
};

// A pedicel's length over its ripe one, for a size of berries.
float stalk_at(float size);

// Swells berries. `scales`: the berries' size over the ripe one, step by step; the last is the final size. Late berries
// grow in the gaps while fewer than `wanted` berries find room; 0: none do.
Swollen swell(std::span<const Branch> branches, std::span<const Swelling> berries,
              std::span<const BunchEnvelope> bounds, std::span<const float> scales, std::size_t wanted = 0);

}  // namespace panicle::bunch
