// The bunch as one model among others: a request's blocks → growth → plant.
//
// Blocks of a request besides everyone's (protocol/request.hpp):
//   grammar or program   where both are absent: the procedure's own
//   steps           uint32: of the derivation, in place of the text's own
//   m, n            int32: segments in place of the profile's; n is n₁ … n₍m−1₎ as the paper counts
//   thinned         uint32: ids of berries taken off by hand
//   leaf.points     float32 × 2: a flat leaf, what leaves on the cane are made from (foliage/flat_leaf.hpp), with
//   leaf.between    float32, leaf.uvs: float32 × 2, leaf.triangles: uint32 × 3; where they are absent, the cane has no
//                   leaves, with a note
//   outputs         `chronicle` besides everyone's
//   stem_sides, berry_segments   uint32: of the meshes; 0: default
//
// Columns of a plant besides everyone's (exports/panicle.h); metres:
//   procedure       text: paper or natural
//   form            float32 × 3: taper, blunt, curve;  fruit: uint32 (Fruit)
//   profile         float32: l, then w, r of each side, px: what the bunch fills, of its own seed; natural alone
//   plan.sides      float32 × 2 for each of four sides: w, r;  plan.counts: int32 × 2: n, rd;
//   plan.axes       int32: m, then n of m − 1 axes;  the same as second.… where there is a second bunch
//   segments.axis   int32 each: first-order axis, −1 for the rachis;  segments.state: uint8 each (State)
//   berries.spheres     float32 × 4 each: centre, radius;  berries.directions × 3;  berries.parent: int32, its pedicel
//   berries.id          uint32 each
//   berries.width … .seeds   float32 each: what grown.hpp calls Traits
//   thinned.id, thinned.why  uint32 each (RemovalReason);  thinned.places: float32 × 3 each
//   berries.pattern.uvs      float32 × 2, berries.pattern.indices: uint32 × 3: of the pattern that all surfaces share
//   berries.positions        float32 × 3, berries.normals × 3, berries.pressed: uint8; of each berry's own surface
//   berries.sky              uint8: of each vertex of each berry, the pattern's or the shared mesh's, berry by berry;
//                            where `sky` is asked for
//   chronicle.…              where it is asked for: how the first bunch's text was derived
//   (lsystem_plant/derivation_trace_columns.hpp); and segments.module, organs.module   uint32 each internode and each
//   berry: the module of its last string that drew it;
//                            0xffffffff for what it did not draw, and for all where the telling is cut short
// and the meshes `stems` (segment: uint32 per vertex; axis: int32 per run), `berry`, `flower` (unit: float32, metres to
// one of its own; a run for each piece, fruit/flower.hpp) and `foliage`.
#pragma once

#include "models/bunch/bunch.hpp"
#include "models/bunch/grown.hpp"
#include "protocol/model.hpp"

namespace panicle::bunch {

extern const Model model;

// The same in two steps, for tests: what a request asks for, and what has grown as a plant.
Result<BunchRequest> read_request(panicle::Request& blocks);
Plant plant_of(GrownBunch&& grown);

}  // namespace panicle::bunch
