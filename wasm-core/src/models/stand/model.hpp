// A stand: many specimens of any models over a ground (docs/models/stand/stand.md). This model places the plants; their
// own models grow them.
//
// Blocks of a request besides the common ones (protocol/request.hpp): `plan`, required, a text of the plan language.
//
// Columns of a plant besides the common ones (exports/panicle.h); kinds are the plan's lines of model/preset, in its
// order:
//   kinds.names      text: a line each, model/preset
//   kinds.place      uint32 × 2: line and column in the plan
//   kinds.seeds      uint32: the number of different plants; 0: as many as plants
//   kinds.spot       text: a line each, the kind of its parent's organs that it hangs at; empty where the plan sets
//                    the height
//   kinds.crown      float32 × 2: width and height at scale 1, metres
//   settings.kind    uint32: the kind of each setting
//   settings.keys    text: a line each, the parameter
//   settings.words   text: a line each; empty where it is a number
//   settings.place   uint32 × 2
//   plants.kind      uint32
//   plants.seed      uint32
//   plants.bearer    int32: the plant that it is attached to, −1 for plants on the ground
//   plants.at        float32 × 3: the foot, metres
//   plants.scale     float32
//   plants.turn      float32: of its x axis, degrees from +x to +z
//   plants.values    float32 × W: drawn values of the settings of its kind, in their order; NaN for words and beyond
//   plants.surroundings  float32 × 16 (surroundings.hpp)
//   ground.size      float32 × 3: width, depth and relief, metres
// Organs are the placements, tagged by the names of their kinds. Meshes: `ground`, and where there is a trellis `posts`
// and `wires`. Counts: plants, kinds, attached plants (named `borne`), and posts where there are any.
#pragma once

#include "protocol/model.hpp"

namespace panicle::stand {

extern const Model model;

}  // namespace panicle::stand
