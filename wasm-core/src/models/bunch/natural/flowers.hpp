// The flowers of a bunch: one for every ball that the text draws.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/bunch/paper/skeleton_drawing.hpp"
#include "models/bunch/skeleton.hpp"

namespace panicle::bunch {

struct Flower {
  std::int32_t parent = -1;  // the internode it sits on: its pedicel's last, or a stem
  std::uint32_t id = 0;
  std::uint32_t bunch = 0;      // 0 the first, 1 the second
  std::uint64_t address = 0;    // unique, made from that of its module
  glm::vec3 heading{0, -1, 0};  // unit
  std::int32_t axis = -1;       // first-order axis, as of its internode
  std::int32_t depth = 0;       // internodes from the root to it
  std::int32_t onward = 0;      // those of them along an axis of second order, beyond an end structure
  std::int32_t place = 0;       // among the flowers of its end structure
  std::uint32_t module = no_module;
  float strength = 1;  // 0 … 1: how far its stem has grown; the radius that the text gives to S
};

// The first internode of an organ that is drawn in several.
std::size_t beginning_of(std::span<const Internode> internodes, std::size_t internode);

// Makes the flowers in the order of the text; those of the balls from `second_from` on are of the second bunch.
std::vector<Flower> flowers_of(std::span<const Internode> internodes, std::span<const Ball> balls,
                               std::size_t second_from);

// Mean number of flowers on an end structure; 0 where there is no end structure.
float flowers_per_end(std::span<const Internode> internodes, std::span<const Flower> flowers);

}  // namespace panicle::bunch
