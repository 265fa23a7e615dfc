// A stand: many specimens of any models over a ground (docs/models/stand/stand.md). This model places them; what grows
// there is grown by their own.
//
// Blocks of a request besides everyone's (protocol/request.hpp): `plan`, which must be there, a text of the plan
// language.
//
// Columns of a plant besides everyone's (exports/panicle.h); kinds are the text's lines of what grows, in its order:
//   kinds.names      text: a line each, model/preset
//   kinds.place      uint32 × 2: line and column in the plan
//   kinds.seeds      uint32: how many different ones there are; 0: as many as plants
//   kinds.spot       text: a line each, at which of its bearer's organs it hangs; empty where the plan says where
//   kinds.crown      float32 × 2: width and height at scale 1, metres
//   settings.kind    uint32: of which kind each setting is
//   settings.keys    text: a line each, the parameter
//   settings.words   text: a line each; empty where it is a number
//   settings.place   uint32 × 2
//   plants.kind      uint32
//   plants.seed      uint32
//   plants.bearer    int32: the plant that bears it, −1 for those that stand
//   plants.at        float32 × 3: the foot, metres
//   plants.scale     float32
//   plants.turn      float32: of its x axis, degrees from +x to +z
//   plants.values    float32 × W: what was drawn for the settings of its kind, in their order; NaN for words and beyond
//   plants.surroundings  float32 × 16 (surroundings.hpp)
//   ground.size      float32 × 3: width, depth and relief, metres
// Organs are the placements, tagged by their kinds' names. Meshes: `ground`, and where there is a trellis `posts` and
// `wires`. Counts: plants, kinds, borne, and posts where there are such.
#pragma once

#include "protocol/model.hpp"

namespace panicle::stand {

extern const Model model;

}  // namespace panicle::stand
