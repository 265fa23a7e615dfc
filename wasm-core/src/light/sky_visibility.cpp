#include "light/sky_visibility.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/mathematics.hpp"
#include "light/density_grid.hpp"

namespace panicle {
namespace {

constexpr float least = 1e-6f;  // a lattice's longest edge

// Builds the density grid of segments and occluders, and lights it from `directions` directions all round. The box of
// their ends has `cells` cells along its longest edge.
VoxelLight light_of(std::span<const Segment> segments, std::span<const Occluder> screens, float cells,
                    std::uint32_t directions) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  const auto hold = [&](const glm::vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  };
  for (const Segment& segment : segments) {
    hold(segment.start);
    hold(segment.end);
  }
  for (const Occluder& screen : screens) hold(screen.place);
  if (!(low.x <= high.x)) low = high = glm::vec3(0);
  const glm::vec3 size = high - low;
  const float edge = std::max({size.x, size.y, size.z, least}) / cells;
  // A margin of one empty cell all around, for points at the surface that face outwards.
  DensityGrid matter(low - edge, high + edge, edge);
  for (const Occluder& screen : screens) matter.put(screen.place, screen.area);
  // A rod hides a quarter of its surface.
  for (const Segment& segment : segments)
    matter.put(0.5f * (segment.start + segment.end),
               0.25f * pi * (segment.radius + segment.radius_end) * glm::distance(segment.start, segment.end));
  return matter.light(all_round(directions));
}

}  // namespace

SkyVisibility::SkyVisibility(std::span<const Segment> segments, std::span<const Occluder> screens, float cells,
                             std::uint32_t directions)
    : light_(light_of(segments, screens, cells, directions)) {}

// The visible share of the sky at a place, 0 … 255.
std::uint8_t SkyVisibility::at(const glm::vec3& place) const { return byte_of(light_.at(place)); }

// The visible share of the sky at each vertex of a mesh.
std::vector<std::uint8_t> SkyVisibility::of(const Mesh& mesh) const {
  return of(mesh.positions.size() / 3, [&](std::size_t v) {
    const float* const p = &mesh.positions[3 * v];
    return glm::vec3(p[0], p[1], p[2]);
  });
}

}  // namespace panicle
