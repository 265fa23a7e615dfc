// A grammar drawn without additions: F draws segments under one skin, S draws balls. A model without a drawing of its
// own uses this.
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
  std::optional<std::uint32_t> steps;  // of the derivation; the text's own where not given
  float metres = 0.001f;               // of one unit of the grammar
  bool meshes = true;
  bool sky = false;  // of the meshes
  bool mesh_fingerprint = false;
  std::uint32_t sides = 12;          // of a tube
  std::uint32_t ball_segments = 16;  // round a ball
  lsystem::Turtle turtle;            // where drawing begins
};

// Derives and interprets a program, and makes its meshes. Errors: those of lsystem's bind, develop and interpret;
// limit.
Result<Plant> draw_plainly(std::shared_ptr<const lsystem::Program> program, const lsystem::Inputs& inputs,
                           const PlainOptions& options, const Limits& limits);

// Converts a drawing to a plant: segments and organs in metres, and the requested meshes `stems` and `balls`, with
// `sky` of the stems' vertices and of each ball. Tags: `stem`, `ball`.
Plant plant_of(const Drawing& drawing, const PlainOptions& options);

}  // namespace panicle
