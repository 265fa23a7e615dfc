// The mesh of one leaf, or of a twig with leaves, that all leaves of a tree share.
#pragma once

#include <cstdint>

#include "foliage/flat_leaf.hpp"
#include "mesh/mesh.hpp"

namespace panicle {

struct Blade {
  // The blade is of length 1; the foot of the petiole is at the origin, the tip near +Y, the upper face looks to +Z.
  Mesh mesh;
  float area = 0;  // of one side, without the petiole
};

// A flat leaf folded along its midrib, puckered between its veins, and arched. `breadth`: against its own. `fold`:
// degrees by which each half stands up. Empty where there is no leaf.
Blade make_blade(const FlatLeaf& leaf, float breadth, float fold);

// `leaves` of them on a twig, left and right by turns and one at its tip, each its own way up: the whole is of length 1
// and stands as a blade does. One leaf is itself.
Blade make_twig(const Blade& leaf, std::uint32_t leaves);

// How long such a twig is, in lengths of a leaf.
float twig_length(std::uint32_t leaves);

// Five flat needles that spread from one place.
Blade make_needles(float breadth);

// A twig with needles all along it.
Blade make_spray(float breadth);

// A flower of five petals that opens towards +Y, across as its petals are: of size 1, on a stalk.
Blade make_blossom();

}  // namespace panicle
