// A tree whose counts are divisor functions (Kim, Kim and Cho 2013; docs/models/growth/growth.md).
//
// Blocks of a request besides everyone's (plant/request.hpp): `rules`, which must be there, a text of the growth
// language; and of plant/flat_leaf.hpp the leaf that it bears, but needles.
//
// Columns of a plant besides everyone's (boundary/panicle.h):
//   segments.shoot   uint32: the shoot that each is of
//   segments.order   uint8: of that shoot, 0 of a trunk
//   segments.born    uint16 as uint32: the step at which that shoot came
//   volumes.id       uint32, one a growth volume, those of child trunks behind the others
//   volumes.shape    float32 × 5: wb, h and wt in metres; grad and towards in degrees
//   volumes.middle   float32: wm, metres
//   volumes.at       float32 × 2: x and z
//   volumes.child    uint8: 1 of a child trunk's
// Organs: `leaf`, `falling` (about to fall), `fallen` (of these, on the ground), `shed` (on the ground in autumn),
// `blossom`, and `bunch`, which has no mesh: where fruit hangs, +Y the way it does. Meshes: `stems` (segment: uint32 a
// vertex), `leaves` and `blossoms`, those that are borne. Counts: branches (without trunks), steps, segments, leaves
// (without those shed), falling, shed, blossoms, bunches.
#pragma once

#include "plant/model.hpp"

namespace panicle::growth {

extern const Model model;

}  // namespace panicle::growth
