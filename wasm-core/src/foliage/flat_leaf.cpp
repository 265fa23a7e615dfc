#include "foliage/flat_leaf.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "foliage/messages.generated.hpp"
#include "foundation/mathematics.hpp"
#include "mesh/normals.hpp"

namespace panicle {
namespace {

constexpr float farthest = 4;  // a flat leaf reaches no farther, in midribs

}  // namespace

// Checks the arrays of a leaf's outline: sizes that match, and coordinates in range; an error for the first that is
// wrong.
Diagnostic check(const FlatLeaf& leaf) {
  const std::size_t points = leaf.points.size() / 2;
  if (leaf.points.size() % 2 != 0 || leaf.between.size() != points || leaf.uvs.size() != 2 * points ||
      leaf.triangles.size() % 3 != 0 || (!leaf.petiole.empty() && leaf.petiole.size() != 2))
    return bad_request(message(messages::foliage::leaf_blocks_differ));
  const auto within = [](std::span<const float> values, float low, float high) {
    return std::all_of(values.begin(), values.end(), [&](float value) { return value >= low && value <= high; });
  };
  if (!within(leaf.points, -farthest, farthest) || !within(leaf.between, 0, 1) || !within(leaf.uvs, 0, 1) ||
      !within(leaf.petiole, 0, farthest))
    return bad_request(message(messages::foliage::leaf_points_out_of_range));
  if (std::any_of(leaf.triangles.begin(), leaf.triangles.end(), [&](std::uint32_t i) { return i >= points; }))
    return bad_request(message(messages::foliage::leaf_triangle_without_point));
  return {};
}

// Bends a strip with the curvature `radians` per length: the point at `along` with `height` above the strip moves to
// its place on the arc. `radians` is not 0.
void bend(float& along, float& height, float radians) {
  const float angle = along * radians;
  const float radius = 1 / radians + height;
  along = radius * sine(angle);
  height = radius * cosine(angle) - 1 / radians;
}

// The mesh of a leaf whose points have moved to `places`. `mirrored`: turns its triangles over.
Mesh raised(const FlatLeaf& leaf, std::span<const glm::vec3> places, bool mirrored) {
  Mesh mesh;
  mesh.positions.reserve(3 * places.size());
  for (const glm::vec3& place : places) put(mesh.positions, place);
  mesh.uvs.assign(leaf.uvs.begin(), leaf.uvs.end());
  mesh.indices.assign(leaf.triangles.begin(), leaf.triangles.end());
  if (mirrored)
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) std::swap(mesh.indices[t + 1], mesh.indices[t + 2]);
  set_normals(mesh);
  return mesh;
}

}  // namespace panicle
