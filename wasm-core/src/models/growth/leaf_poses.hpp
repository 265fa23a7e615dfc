// Rotations of the leaves of a twig, four at a time.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "foundation/lanes.hpp"

namespace panicle::growth {

struct Twig {
  glm::vec3 along, one, other;  // orthogonal unit vectors, the first towards its tip
};

// Noise of four leaves: angle around the twig, and a random direction as its height, −1 … 1, and azimuth. Angles in
// turns.
struct LeafNoise {
  Four about, height, around;
};

// Rotations from a leaf's frame (tip at +Y, face to +Z) to the plant's: unit quaternions x y z w. `stray`: weight of
// the random direction against the sky in the direction of faces.
std::array<glm::vec4, 4> leaf_poses(const Twig& twig, const LeafNoise& noise, float stray);
std::array<glm::vec4, 4> needle_poses(const Twig& twig, const LeafNoise& noise);

}  // namespace panicle::growth
