// The blade of a grapevine leaf.
#pragma once

#include <cstdint>

#include "geometry/mesh.hpp"

namespace panicle::bunch {

struct LeafOptions {
  std::uint64_t seed = 1;  // lobes, teeth and folds differ with it
  float opening = 1;       // 0: folded along the midrib as it leaves the bud … 1: spread out
  float wilting = 0;       // 0 … 1: how far it hangs and curls, as leaves do before they fall
};

// Where the chart of a leaf has the point at which the petiole joins the blade, and how much of it the midrib takes.
inline constexpr float leaf_petiole_u = 0.5f, leaf_petiole_v = 0.16f;
inline constexpr float leaf_chart_scale = 0.48f;

// Angles of the five main veins from the midrib, to either side, in degrees (the ampelographers' α and α + β).
inline constexpr float leaf_upper_vein = 52, leaf_lower_vein = 108;

// Lengths in midribs: the petiole joins at the origin, the tip lies near (0, 1, 0), the upper face looks to +Z and is
// counter-clockwise from there. One surface with an edge, 568 vertices. Its uv are the blade spread flat: u =
// leaf_petiole_u + leaf_chart_scale · x, v = leaf_petiole_v + leaf_chart_scale · y, within 0 … 1, so that the veins run
// straight from (leaf_petiole_u, leaf_petiole_v) at the angles above, whatever the folds.
Mesh make_leaf(const LeafOptions& options);

}  // namespace panicle::bunch
