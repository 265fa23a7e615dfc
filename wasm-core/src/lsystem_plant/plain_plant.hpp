// A grammar drawn as it stands: what F draws are segments under one skin, what S draws are balls. A model that has
// nothing to add is this and no more.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "lsystem/lsystem.hpp"
#include "lsystem_plant/drawing.hpp"
#include "plant/fingerprint.hpp"
#include "plant/plant.hpp"

namespace panicle {

struct PlainOptions {
  std::uint64_t seed = 1;
  std::optional<std::uint32_t> steps;  // of the derivation; as the text says where it is not given
  float metres = 0.001f;               // of one unit of the grammar
  bool meshes = true;
  bool sky = false;  // of the meshes
  bool mesh_fingerprint = false;
  std::uint32_t sides = 12;          // of a tube
  std::uint32_t ball_segments = 16;  // round a ball
  lsystem::Turtle turtle;            // where drawing begins
};

// Derives, interprets and dresses. Errors: those of lsystem's bind, develop and interpret; limit.
Result<Plant> draw_plainly(std::shared_ptr<const lsystem::Program> program, const lsystem::Inputs& inputs,
                           const PlainOptions& options, const Limits& limits);

// What has been drawn as a plant: segments and organs in metres, and the meshes `stems` and `balls` where they are
// asked for, `sky` of the stems' vertices and of each ball. Tags: `stem`, `ball`.
Plant plant_of(const Drawing& drawing, const PlainOptions& options);

}  // namespace panicle
