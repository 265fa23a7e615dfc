// Any text grown as a plant (docs/models/grammar/grammar.md): its lines are tubes, its spheres balls, its polygons
// blades, its surfaces organs.
//
// Blocks of a request besides everyone's (protocol/request.hpp), of which `grammar` or `program` must be there:
//   steps              uint32: of the derivation, in place of the text's own
//   constants.names    text: names of the text's `#define`s and `#input`s, a line each
//   constants.values   float32: one a name
//   areas.…, path      volumes that a text may ask for, and places of its main branch (areas.hpp)
//   outputs            `string` besides everyone's: the derived string as text; `chronicle`: how it was derived;
//                      `coarse`: meshes that do in passing
//
// Columns of a plant besides everyone's (exports/panicle.h):
//   segments.module, organs.module   uint32 each: the module that drew it, by its place in the last string, from 0;
//                                    0xffffffff for all where the derivation is told, and that is cut short
//   segments.colour, organs.colour   uint8 each: 1 … 8 of the document's palette
//   segments.area, segments.main     uint8 each, where the text declares their role (belonging.hpp): the growth area,
//                                    from 1, and whether it is the main branch's
//   areas.volume, areas.clothed      float32 each, with the measures, one a growth area: m³; share of its surface
//   within
//                                    a leaf's length of a leaf's base
//   string                           text, where it is asked for: it reads back as an axiom
//   chronicle.…                      where it is asked for: how it was derived
//   (lsystem_plant/derivation_trace_columns.hpp)
// Measures: measures.generated.hpp. Counts: modules (of the last string), steps (that were taken), segments, organs,
// polygons. Tags: stem; ball, polygon and the names of surfaces.hpp. Meshes: `stems` (segment: uint32 a vertex; colour:
// uint8 a run; a run a colour), and where there are such: `blades` (colour: uint8 a run; organ: uint32 a run; a run a
// polygon that shows), `balls` of radius 1 and a mesh for each surface that is drawn, by its name. Sky: of the vertices
// of stems and blades, and of organs in the mean.
#pragma once

#include "protocol/model.hpp"

namespace panicle::grammar {

extern const Model model;

}  // namespace panicle::grammar
