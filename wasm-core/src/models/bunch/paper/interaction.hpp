// How a newborn internode finds room in the grown structure (Huang et al. 2013, section 4.3.2).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "lsystem/lsystem.hpp"
#include "spatial/sphere_grid.hpp"

namespace panicle::bunch {

struct InteractionOptions {
  float delta = 15;          // δ, degrees: the turn of a full push, and the most an internode may turn in total
  std::uint32_t tries = 50;  // t: adjustments before an internode is cut or a pedicel withers
  float sag = 2;             // degrees bent towards gravity where there is no obstacle
};

// An organ that looks for room: an internode probes with a small sphere at its tip, a pedicel with its berry beyond the
// tip.
struct Newborn {
  bool pedicel = false;
  bool flat = false;  // turns in the turtle's heading–left plane alone (the 2-D communication module)
  float length = 0;
  float radius = 0;                              // of the probe
  std::uint32_t parent = SphereGrid::no_sphere;  // the parent's own tip sphere, no obstacle
  glm::vec3 tie{0, -1, 0};                       // unit; the direction to evade where a push is 0
};

// The answer: the turns +(θ)&(φ), in degrees, that lead to free space, and the sphere placed there.
struct Room {
  bool found = false;
  float theta = 0;  // 0 without room
  float phi = 0;
  Sphere sphere;
  Sphere unturned;                // its place without turning
  std::uint32_t adjustments = 0;  // number made or tried
  float turned = 0;               // degrees in total
};

// Finds room: probes, turns towards the push and probes again until the newborn is free or has used up its adjustments;
// then lets it sag. Nothing is added to `structure`.
Room find_room(const SphereGrid& structure, const lsystem::Turtle& turtle, const Newborn& newborn,
               const InteractionOptions& options);

}  // namespace panicle::bunch
