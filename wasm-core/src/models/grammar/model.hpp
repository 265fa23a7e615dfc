// Any grammar grown as a plant (docs/models/grammar/grammar.md): its lines are tubes, its spheres balls, its polygons
// blades, its surfaces organs.
//
// Blocks of a request besides the common ones (protocol/request.hpp); `grammar` or `program` is required:
//   steps              uint32: of the derivation, in place of the grammar's own
//   constants.names    text: names of the grammar's `#define`s and `#input`s, a line each
//   constants.values   float32: one a name
//   areas.…, path      volumes that a grammar may query, and places of its main branch (areas.hpp)
//   outputs            besides the common ones: `string`: the derived string as text; `chronicle`: trace of the
//                      derivation; `coarse`: meshes of preview quality
//
// Columns of a plant besides the common ones (exports/panicle.h):
//   segments.module, organs.module   uint32 each: index in the last string of the module that drew it, from 0;
//                                    0xffffffff for all where the derivation's trace is cut short
//   segments.colour, organs.colour   uint8 each: 1 … 8 of the document's palette
//   segments.area, segments.main     uint8 each, where the grammar declares the role (area_membership.hpp): the growth
//                                    area, from 1, and whether it belongs to the main branch
//   areas.volume, areas.clothed      float32 each, with the measures, one a growth area: m³; share of its surface
//                                    within a leaf's length of a leaf's base
//   string                           text, where requested: it can be read again as an axiom
//   chronicle.…                      where requested: the trace of the derivation
//                                    (lsystem_plant/derivation_trace_columns.hpp)
// Measures: measures.generated.hpp. Counts: modules (of the last string), steps (taken), segments, organs, polygons.
// Tags: stem; ball, polygon and the names of surfaces.hpp. Meshes: `stems` (segment: uint32 a vertex; colour: uint8 a
// run; a run a colour), and where present: `blades` (colour: uint8 a run; organ: uint32 a run; a run a polygon with
// area), `balls` of radius 1 and a mesh for each surface in use, by its name. Sky: of the vertices of stems and blades,
// and the mean of organs.
#pragma once

#include "protocol/model.hpp"

namespace panicle::grammar {

extern const Model model;

}  // namespace panicle::grammar
