// A leaf blade in a request: grown by another model, baked flat (docs/foliage.md), and bent by the model that attaches
// it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "foundation/result.hpp"
#include "mesh/mesh.hpp"

namespace panicle {

// Lengths in midribs: the petiole joins at the origin, the tip lies near (0, 1). Empty: there is none.
struct FlatLeaf {
  std::span<const float> points;             // × 2; the first is the petiole's
  std::span<const float> between;            // one a point: 0 on one of the larger veins … 1 in the midst between them
  std::span<const float> uvs;                // × 2, within 0 … 1
  std::span<const std::uint32_t> triangles;  // × 3, counter-clockwise
  std::span<const float> petiole = {};       // length and width; empty where the plant has petioles of its own
};

// Validates a leaf. Errors: bad_request.
Diagnostic check(const FlatLeaf& leaf);

// Bends a line of a leaf into an arc, downwards, by `radians` (> 0) a length. Heights above the line are preserved.
void bend(float& along, float& height, float radians);

// Returns the leaf's mesh with its points at `places` and normals that average its triangles'. `mirrored`: swaps left
// and right, so that the upper face is counter-clockwise again.
Mesh raised(const FlatLeaf& leaf, std::span<const glm::vec3> places, bool mirrored = false);

}  // namespace panicle
