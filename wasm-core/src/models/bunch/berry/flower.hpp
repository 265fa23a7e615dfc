// The flower mesh that all flowers of a bunch share, in pieces that are shown separately.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"
#include "models/bunch/berry/berry_body.hpp"

namespace panicle::bunch {

// A part of the flower's mesh.
struct FlowerPiece : MeshRange {
  enum class Kind : std::uint32_t {
    stamens = 0,  // filaments, anthers and the short style, about an ovary
    cap = 1,      // a grape's petals, grown together: they come off as one (calyptra)
    pistil = 2,   // an ovary on a pedicel of its own: a flower that grows no berry
    petals = 3,   // a bramble's
    calyx = 4,    // a bramble's sepals, bent back behind flower and fruit; about the seat, not the ovary
  };
  Kind kind = Kind::stamens;
};

// A flower about an ovary of unit radius at the origin, facing +Y; the ovary itself is the berry. u runs round; v is
// below 0.25 on green parts, to 0.5 on filaments and style, to 0.75 on anthers, above on petals.
struct FlowerMesh {
  Mesh mesh;
  std::vector<FlowerPiece> pieces;
  float unit = 0;  // metres to one of the mesh
};

FlowerMesh make_flower(Fruit fruit);

}  // namespace panicle::bunch
