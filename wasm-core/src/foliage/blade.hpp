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

// Makes a blade from a flat leaf: folded along its midrib, puckered between its veins, and arched. `breadth`: a factor
// of its width. `fold`: degrees by which each half stands up. Empty for an empty leaf.
Blade make_blade(const FlatLeaf& leaf, float breadth, float fold);

// Makes a twig with so many copies of a leaf, alternately left and right along a thin stem and one at its tip, with
// varied poses. The whole has length 1, starts at the origin and points to +Y, as a blade does. A twig of one leaf is
// the leaf.
Blade make_twig(const Blade& leaf, std::uint32_t leaves);

// The length of such a twig, in lengths of a leaf.
float twig_length(std::uint32_t leaves);

// Five flat needles that spread from one place.
Blade make_needles(float breadth);

// A twig with needles all along it.
Blade make_spray(float breadth);

// A flower of five petals that opens towards +Y, across as its petals are: of size 1, on a stalk.
Blade make_blossom();

}  // namespace panicle
