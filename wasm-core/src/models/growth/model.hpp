// A tree whose counts are divisor functions (Kim, Kim and Cho 2013; docs/models/growth/growth.md).
//
// Blocks of a request besides everyone's (protocol/request.hpp): `rules`, which must be there, a text of the growth
// language; of foliage/flat_leaf.hpp the leaf that it bears, but needles; and `surroundings` (float32 × 16), what
// stands about it: eight heights of the horizon, in degrees above level, at the azimuths 0°, 45° … (from +X to +Z),
// then eight metres of free room from the origin in those directions. Absent: it stands alone. `levels` (uint32): how
// many levels are made where they are asked for, from near to far; absent: all four.
//
// Columns of a plant besides everyone's (exports/panicle.h):
//   segments.shoot   uint32: the shoot that each is of
//   segments.order   uint8: of that shoot, 0 of a trunk
//   segments.born    uint16 as uint32: the step at which that shoot came
//   volumes.id       uint32, one a growth volume, those of child trunks behind the others
//   volumes.shape    float32 × 5: wb, h and wt in metres; grad and towards in degrees
//   volumes.middle   float32: wm, metres
//   volumes.at       float32 × 2: x and z
//   volumes.child    uint8: 1 of a child trunk's
//   levels.tolerance float32, one a level that was asked for: the largest thing that it leaves out or merges, metres
// Organs: `leaf`, `falling` (about to fall), `fallen` (of these, on the ground), `shed` (on the ground in autumn),
// `blossom`, and `bunch`, which has no mesh: where fruit hangs, +Y the way it does. Meshes: `stems` (segment: uint32 a
// vertex), `leaves` and `blossoms`, those that are borne; where `outputs` names `levels` also `level0` … `level3`, or
// the first of these, of material `level`, the whole tree as one mesh for one distance each, from near to far: runs
// `bark`, `leaves` and `blossoms` (always all three), no texture coordinates, a byte of sky a vertex. What lies on the
// ground is not among them. Counts: branches (without trunks), steps, segments, leaves (without those shed), falling,
// shed, blossoms, bunches.
#pragma once

#include "protocol/model.hpp"

namespace panicle::growth {

extern const Model model;

}  // namespace panicle::growth
