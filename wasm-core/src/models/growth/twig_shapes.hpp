// Shapes of twigs that many places of a crown share: an axis with side twigs, buds, and leaves by the arrangement of
// the species.
#pragma once

#include <cstdint>
#include <vector>

#include "foliage/blade.hpp"
#include "mesh/mesh.hpp"

namespace panicle::growth {

// Arrangement of leaves and side twigs on an axis: 2/5 spiral (oak, apple), alternately in two ranks (beech, lime), or
// in crossed pairs (maple, olive).
enum class Phyllotaxis : std::uint8_t { spiral, two_ranked, opposite };

struct TwigHabit {
  std::uint32_t shapes = 0;  // number of shapes; 0: no twigs
  Phyllotaxis phyllotaxis = Phyllotaxis::spiral;
  std::uint32_t leaves = 12;  // on a whole twig with its side twigs
  std::uint32_t sides = 3;    // number of side twigs
  float leaf = 0.3f;          // length of a leaf, in lengths of the twig
  float thickness = 0.018f;   // at the base, in lengths of the twig
  float bud = 0;              // length of a bud, in lengths of the twig; 0: no buds
  float spurs = 0;            // share of short shoots, whose leaves are in a rosette: the last shape
  float crowd = 0;            // how much leaves crowd at the tip, 0 … 1
  float droop = 0;            // how far side twigs hang, as a tangent
  float stray = 0.5f;         // of leaves' faces
  enum class Leaf : std::uint8_t { flat, pair, needle } foliage = Leaf::flat;
  float needle_breadth = 1;  // of needles
};

// One shape. The axis begins at the origin and ends near +Y, at 1; leaves face +Z.
struct TwigShape {
  Mesh wood;
  Mesh leaves;
  float area = 0;  // of one side of all leaves
  std::uint32_t leaf_count = 0, tips = 0;
};

// The place of a leaf or a side twig on a twig: its number on the axis decides its side.
struct TwigNode {
  float along = 0;    // 0 the base of its axis … 1 its tip
  float azimuth = 0;  // about the axis, degrees; 0 is +X, 90 +Z
};

// The nodes of `count` leaves on an axis, from its base to its tip. Pairs share one place.
std::vector<TwigNode> twig_nodes(Phyllotaxis phyllotaxis, std::uint32_t count, float crowd);

// The shapes of a species. `unfolded`: the size of leaves over their full size, by shape; 0: no leaves. `blade` is
// empty for needles. The last shape is the spur where the habit has spurs.
std::vector<TwigShape> twig_shapes(const TwigHabit& habit, const Blade& blade, const std::vector<float>& unfolded,
                                   bool with_buds);

// The leaves of a shape on the ground: as many, flat, scattered around the origin, with faces to +Z.
Mesh leaf_litter(const TwigHabit& habit, const Blade& blade, std::uint32_t leaves);

}  // namespace panicle::growth
