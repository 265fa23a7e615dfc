// Berries swell among each other: contacts, pedicels, stems and gravity solved together, step by step as they grow.
//
// Extended position-based dynamics (Macklin, Müller & Chentanez 2016, XPBD: Position-Based Simulation of Compliant
// Constrained Dynamics, equations 17 and 18) without velocities: growth is slow, so every step starts at rest.
// Constraints are solved one after another in a fixed order, so that the same bunch comes out everywhere.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/bunch/grown.hpp"
#include "models/bunch/paper/envelope.hpp"
#include "models/bunch/stance.hpp"

namespace panicle::bunch {

// A stem that berries hang from and lean on; millimetres. Parents come first.
struct Branch {
  glm::vec3 start{0}, end{0};  // before anything bends
  std::int32_t parent = -1;
  float radius = 0;
  float give = 0;     // 0 … 1: how readily its end gives way against its start
  bool sags = false;  // under its berries; the rachis hangs as it is
};

struct Swelling {
  std::uint32_t branch = 0;               // whose end the pedicel grows from
  glm::vec3 heading{0, -1, 0};            // of the pedicel, unit
  float stalk = 0;                        // full length of the pedicel
  float half_width = 0, half_length = 0;  // ripe
  std::uint32_t bunch = 0;                // which outline it keeps to
  bool taken = false;                     // taken off by hand once it is grown
  bool late = false;                      // joins only where others found no room, in the order given
};

// An outline as it hangs; millimetres.
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

// A pedicel's length over its ripe one, when berries are of a size.
float stalk_at(float size);

// `scales`: the berries' size over the ripe one, step by step; the last is the size they end with. Where fewer than
// `wanted` berries find room, late ones grow up in the gaps; 0: none do.
Swollen swell(std::span<const Branch> branches, std::span<const Swelling> berries,
              std::span<const BunchEnvelope> bounds, std::span<const float> scales, std::size_t wanted = 0);

}  // namespace panicle::bunch
