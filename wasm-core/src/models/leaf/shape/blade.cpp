#include "models/leaf/shape/blade.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "foundation/vectors.hpp"
#include "mesh/normals.hpp"
#include "mesh/triangulation.hpp"
#include "models/leaf/blade_points.hpp"

namespace panicle::particles::leaf {
namespace {

constexpr float groove_over_ridge = 0.4f;  // depth of grooves in the upper face, over height of ridges on the lower
constexpr float thin_margin = 0.5f;        // of the blade's thickness

// Adds the walls between the upper and the lower face along the margin, with vertices of their own. `ring` is the
// number of points on the margin, which come first in both meshes.
void add_rim(Mesh& lower, const Mesh& upper, std::size_t ring) {
  const auto first = static_cast<std::uint32_t>(lower.positions.size() / 3);
  const auto count = static_cast<std::uint32_t>(ring);
  for (std::size_t i = 0; i < ring; ++i) {
    const glm::vec3 top = vector_at(upper.positions, i), bottom = vector_at(lower.positions, i);
    const glm::vec3 along =
        vector_at(upper.positions, (i + 1) % ring) - vector_at(upper.positions, (i + ring - 1) % ring);
    const glm::vec3 outward = glm::cross(along, top - bottom);
    for (const glm::vec3& place : {top, bottom}) {
      put(lower.positions, place);
      put(lower.normals, unit_normal(outward));
      put(lower.uvs, {upper.uvs[2 * i], upper.uvs[2 * i + 1]});
    }
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t top = first + 2 * i, next = first + 2 * ((i + 1) % count);
    put(lower.indices, top, top + 1, next);
    put(lower.indices, next, top + 1, next + 1);
  }
}

}  // namespace

// The square around the outline that textures show.
ChartSquare chart_square(const Outline& outline) {
  const glm::vec3 size = outline.high() - outline.low();
  const float side = std::max(size.x, size.y);
  const glm::vec3 middle = 0.5f * (outline.low() + outline.high());
  return {{middle.x - 0.5f * side, middle.y - 0.5f * side}, side};
}

// Builds the upper and the lower face of a blade; empty if the outline is too narrow to be triangulated.
std::vector<PlantMesh> make_blade(const Margin& margin, const Outline& outline, std::span<const VeinPiece> veins,
                                  const Bending& bending, const BladeForm& form) {
  const BladePoints placed = place_points(margin, outline, veins, form.detail);
  const std::vector<std::uint32_t> triangles = triangulate(placed.points, placed.ring);
  if (triangles.empty()) return {};
  // Points that no triangle uses are left out; the ring is used completely, so that it stays first.
  std::vector<std::int32_t> number(placed.points.size(), -1);
  std::vector<std::uint32_t> used;
  for (std::uint32_t i = 0; i < placed.ring; ++i) {
    number[i] = static_cast<std::int32_t>(i);
    used.push_back(i);
  }
  for (const std::uint32_t i : triangles)
    if (number[i] < 0) {
      number[i] = static_cast<std::int32_t>(used.size());
      used.push_back(i);
    }
  const ChartSquare square = chart_square(outline);
  // Both faces from the middle surface: half of the thickness to either side, and the relief of the veins.
  Mesh upper, lower;
  std::vector<float> edge;
  for (std::size_t k = 0; k < used.size(); ++k) {
    const std::uint32_t i = used[k];
    const glm::vec2 p = placed.points[i];
    const glm::vec3 middle = bending(p), normal = bending.normal(p);
    const float half = 0.5f * form.thickness * (k < placed.ring ? thin_margin : 1.0f);
    const float ridge = k < placed.ring ? 0 : form.relief * bending.scale * placed.rise[i];
    put(upper.positions, middle + (half - std::min(groove_over_ridge * ridge, half)) * normal);
    put(lower.positions, middle - (half + ridge) * normal);
    put(upper.normals, normal);
    put(lower.normals, -normal);
    put(upper.uvs, (p - square.low) / square.size);
    edge.push_back(k < placed.ring ? 0 : outline.about_distance({p.x, p.y, 0}));
  }
  lower.uvs = upper.uvs;
  for (std::size_t k = 0; k < triangles.size(); k += 3) {
    const auto corner = [&](std::size_t at) { return static_cast<std::uint32_t>(number[triangles[k + at]]); };
    put(upper.indices, corner(0), corner(1), corner(2));
    put(lower.indices, corner(0), corner(2), corner(1));
  }
  add_rim(lower, upper, placed.ring);
  // The rim's own vertices lie on the margin.
  std::vector<float> edge_below = edge;
  edge_below.resize(lower.positions.size() / 3, 0);
  std::vector<PlantMesh> faces;
  faces.push_back({"upper", "blade", std::move(upper), {}, {}});
  faces.back().columns.add("edge", std::move(edge));
  faces.push_back({"lower", "blade", std::move(lower), {}, {}});
  faces.back().columns.add("edge", std::move(edge_below));
  return faces;
}

}  // namespace panicle::particles::leaf
