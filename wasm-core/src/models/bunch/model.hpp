// The bunch as a `Model`: a request's blocks → growth → plant.
//
// Blocks of a request besides those of all models (protocol/request.hpp):
//   grammar or program   where both are absent: the procedure's own
//   steps           uint32: of the derivation, in place of the text's own
//   m, n            int32: segments in place of the profile's; n is n₁ … n₍m−1₎ as the paper counts
//   thinned         uint32: ids of berries removed by hand
//   leaf.points     float32 × 2: a flat leaf, the shape of the leaves on the cane (foliage/flat_leaf.hpp), with
//   leaf.between    float32, leaf.uvs: float32 × 2, leaf.triangles: uint32 × 3; where they are absent, the cane has no
//                   leaves, with a note
//   outputs         `chronicle` besides those of all models
//   stem_sides, berry_segments   uint32: of the meshes; 0: default
//
// Columns of a plant besides those of all models (exports/panicle.h); metres:
//   procedure       text: paper or natural
//   form            float32 × 3: taper, blunt, curve;  fruit: uint32 (Fruit)
//   profile         float32: l, then w, r of each side, px: the outline of this seed's bunch; natural procedure only
//   plan.sides      float32 × 2 for each of four sides: w, r;  plan.counts: int32 × 2: n, rd;
//   plan.axes       int32: m, then n of m − 1 axes;  the same as second.… where there is a second bunch
//   segments.axis   int32 each: first-order axis, −1 for the rachis;  segments.state: uint8 each (State)
//   berries.spheres     float32 × 4 each: centre, radius;  berries.directions × 3;  berries.parent: int32, its pedicel
//   berries.id          uint32 each
//   berries.width … .seeds   float32 each: the members of Traits (grown.hpp)
//   thinned.id, thinned.why  uint32 each (RemovalReason);  thinned.places: float32 × 3 each
//   berries.pattern.uvs      float32 × 2, berries.pattern.indices: uint32 × 3: of the pattern that all surfaces share
//   berries.positions        float32 × 3, berries.normals × 3, berries.pressed: uint8; of each berry's own surface
//   berries.sky              uint8: of each vertex of each berry, the pattern's or the shared mesh's, berry by berry;
//                            if `sky` is requested
//   chronicle.…              if requested: how the first bunch's text was derived
//                            (lsystem_plant/derivation_trace_columns.hpp); with segments.module, organs.module:
//                            uint32 each internode and each berry: the module of the last string that drew it;
//                            0xffffffff for parts that no module drew, and for all if the trace is cut short
// and the meshes `stems` (segment: uint32 per vertex; axis: int32 per run), `berry`, `flower` (unit: float32, metres to
// one of its own; a run for each piece, fruit/flower.hpp) and `foliage`.
#pragma once

#include "models/bunch/bunch.hpp"
#include "models/bunch/grown.hpp"
#include "protocol/model.hpp"

namespace panicle::bunch {

extern const Model model;

// The two steps of the model, for tests: read a request's blocks, and turn a grown bunch into a plant.
Result<BunchRequest> read_request(panicle::Request& blocks);
Plant plant_of(GrownBunch&& grown);

}  // namespace panicle::bunch
