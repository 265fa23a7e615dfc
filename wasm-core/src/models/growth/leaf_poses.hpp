// Which way the leaves of a twig stand, four of them at a time.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "foundation/lanes.hpp"

namespace panicle::growth {

struct Twig {
  glm::vec3 along, one, other;  // unit vectors at right angles, the first to its tip
};

// Of each leaf: how far it stands round about the twig, and a direction by which it is strewn: its height, −1 … 1, and
// its way round. In turns.
struct LeafNoise {
  Four about, height, around;
};

// From a leaf's frame (its tip at +Y, its face to +Z) to where it stands: unit quaternions x y z w.
// `stray`: how far faces look elsewhere than to the sky, against that.
std::array<glm::vec4, 4> leaf_poses(const Twig& twig, const LeafNoise& noise, float stray);
std::array<glm::vec4, 4> needle_poses(const Twig& twig, const LeafNoise& noise);

}  // namespace panicle::growth
