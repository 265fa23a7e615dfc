// A flower of a grammar on generalized maps (Petrenko 2014; docs/models/flower/flower.md).
//
// Blocks of a request besides the common ones (protocol/request.hpp): `text`, required, a text of the flower language;
// `values.names` (text, words) and `values` (float32, as many): values of the text's variables; a note lists unknown
// names. Outputs besides the common ones: `map`.
//
// A segment for each volume on the axis of its organ, tagged by its label. Columns besides the common ones
// (exports/panicle.h), of volumes in the order in which they were made:
//   volumes.label      uint32, into labels (text, words)
//   labels.module      uint32: the module of each, from 1 on; 0 of the text itself
//   volumes.order      uint32
//   volumes.parent     uint32: the volume that each grew from or is attached to; 0xffffffff of the first. The new
//   volume
//                      of a split comes after volumes that may be attached to it
//   volumes.face       uint32: the parent's face, 0 O, 1 E, from 2 on C1 …
//   volumes.attached   uint8: 1 where it is not sewn to that face
//   volumes.values     float32 × 9: N, T, atx, aty, atz, H, L, W, m
//   volumes.line       uint32: the line of the text where each is grown; 0 for none
//   volumes.call       uint32: the line where its module is called; 0 for none
//   materials.number   uint32, one a mesh
//   materials.name     text, a line a mesh: its name in the text; empty where it has none
//   materials.colours  uint32 × 4: where an organ begins and ends, of its margin and of its veins; red, green and blue
//                      of 8 bits each
//   materials.paint    float32 × 6: foot, width of the margin, number of veins, their strength, light that comes
//                      through, 1 where veins are feathered
// With `map`: alpha0 … alpha3, darts.volume, darts.vertex (uint32 a dart), vertices.position (float32 × 3). With
// `levels`, and without columns of volumes and labels unless `meshes` are requested: materials of levels after those of
// meshes, and of level0 … level3 (levels.hpp) besides `sky` paint, uint8 a vertex: the index of its material. Meshes:
// skin.hpp, and levels. Counts: volumes, darts, organs, triangles.
#pragma once

#include "protocol/model.hpp"

namespace panicle::flower {

extern const Model model;

}  // namespace panicle::flower
