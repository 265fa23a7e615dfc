// A flower of a grammar on generalized maps (Petrenko 2014; docs/models/flower/flower.md).
//
// Blocks of a request besides everyone's (protocol/request.hpp): `text`, which must be there, a text of the flower
// language; `values.names` (text, words) and `values` (float32, as many): variables of the text that are given; a note
// tells of those that it does not have. Outputs besides everyone's: `map`.
//
// A segment for each volume that has grown end on end in its organ, tagged by its label. Columns besides everyone's
// (exports/panicle.h), of volumes in the order in which they were made:
//   volumes.label      uint32, into labels (text, words)
//   labels.module      uint32: the module that each is of, from 1 on; 0 of the text itself
//   volumes.order      uint32
//   volumes.parent     uint32: the volume that each stands on; 0xffffffff of the first. What a split has made comes
//                      behind what may stand on it
//   volumes.face       uint32: on which of its faces, 0 O, 1 E, from 2 on C1 …
//   volumes.attached   uint8: 1 where it is sewn to nothing there
//   volumes.values     float32 × 9: N, T, atx, aty, atz, H, L, W, m
//   volumes.line       uint32: the line of the text where each is grown; 0 for none
//   volumes.call       uint32: the line where its module is called; 0 for none
//   materials.number   uint32, one a mesh
//   materials.name     text, a line a mesh: what the text calls it; empty where it does not
//   materials.colours  uint32 × 4: where an organ begins and ends, of its margin and of its veins; red, green and blue
//                      of 8 bits each
//   materials.paint    float32 × 6: foot, width of the margin, number of veins, their strength, light that comes
//                      through, 1 where veins are feathered
// with `map`: alpha0 … alpha3, darts.volume, darts.vertex (uint32 a dart), vertices.position (float32 × 3).
// with `levels`, and without those of volumes and labels where no `meshes` are asked for: materials of levels behind
// those of meshes, and of level0 … level3 (levels.hpp) besides `sky` paint, uint8 a vertex: which of the materials it
// is of. Meshes: skin.hpp, and levels. Counts: volumes, darts, organs, triangles.
#pragma once

#include "protocol/model.hpp"

namespace panicle::flower {

extern const Model model;

}  // namespace panicle::flower
