// A tree whose counts are divisor functions (Kim, Kim and Cho 2013; docs/models/growth/growth.md).
//
// Blocks of a request besides the common ones (protocol/request.hpp): `rules`, required, a text of the growth language;
// the leaf of foliage/flat_leaf.hpp, except for needles; `surroundings` (float32 × 16), light and room around the tree:
// eight heights of the horizon, in degrees above level, at the azimuths 0°, 45° … (from +X to +Z), then eight metres of
// free room from the origin in those directions. Absent: nothing around it. `levels` (uint32): the number of levels to
// make where they are requested, from near to far; absent: all four. `edits` (uint32 × 5) and `edits.points` (float32):
// edits of single branches by hand (edits.hpp); absent: none.
//
// Columns of a plant besides the common ones (exports/panicle.h):
//   segments.shoot   uint32: the shoot of each
//   segments.order   uint8: of that shoot, 0 of a trunk
//   segments.born    uint16 as uint32: the step of that shoot's first internode
//   segments.dead    uint8: 1 for dead wood without bark; absent where there is none
//   shoots.address   uint32 × 2: of each shoot its address, by which edits name it, lower half first
//   volumes.id       uint32, one a growth volume; child trunks' volumes come after the others
//   volumes.shape    float32 × 5: wb, h and wt in metres; grad and towards in degrees
//   volumes.middle   float32: wm, metres
//   volumes.at       float32 × 2: x and z
//   volumes.child    uint8: 1 for a child trunk's
//   levels.tolerance float32, one a requested level: the size of its largest omitted or merged part, metres
// Organs: `leaf`, `falling` (about to fall), `fallen` (of these, on the ground), `shed` (on the ground in autumn),
// `blossom`, `bunch`, a place without a mesh where fruit hangs along +Y, and `twig`, whose leaves are an organ of their
// own. Meshes: `stems` (segment: uint32 a vertex), `leaves` and `blossoms` where present, and of twigs in place of
// `leaves` those of each shape: `twig 1` … of material `twig`, `leaves 1` …, and on the ground `litter 1` …; where
// `outputs` names `levels` also `level0` … `level3`, or the first of these, of material `level`: the whole tree as one
// mesh for one distance each, from near to far, with the runs `bark`, `leaves` and `blossoms` (always all three),
// without texture coordinates, with a byte of sky a vertex, and without leaves on the ground. Counts: branches (without
// trunks), steps, segments, twigs, leaves (without those shed), falling, shed, blossoms, bunches.
#pragma once

#include "protocol/model.hpp"

namespace panicle::growth {

extern const Model model;

}  // namespace panicle::growth
