#include "generalized_map/boundary.hpp"

namespace panicle::generalized_map {
namespace {

// The orientation of each dart (a corner of a face at one end of an edge): 1 if it runs counter-clockwise seen from
// outside of its volume. Every involution α leads to a dart of the other orientation.
std::vector<std::uint8_t> orientations(const Map& map) {
  // The darts of prisms have their orientation by number; in volumes that were cut, other darts lie between.
  if (map.cuts().empty()) {
    std::vector<std::uint8_t> forward(map.darts());
    for (std::uint32_t v = 0; v < map.volumes(); ++v) {
      const Volume& volume = map.volume(v);
      const std::uint32_t end = volume.first + 2 * volume.order, all = volume.first + prism_darts(volume.order);
      for (std::uint32_t d = volume.first; d < all; ++d) forward[d] = (d - volume.first) % 2 == (d < end ? 1 : 0);
    }
    return forward;
  }
  std::vector<std::uint8_t> kinds(map.darts(), 0);  // 0 unseen, 1 and 2
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t v = 0; v < map.volumes(); ++v) {
    const std::uint32_t first = map.end_corner(v, 0);
    if (kinds[first] != 0) continue;
    kinds[first] = 1;
    waiting.push_back(first);
    while (!waiting.empty()) {
      const std::uint32_t dart = waiting.back();
      waiting.pop_back();
      for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t other = map.alpha(i, dart);
        if (kinds[other] != 0) continue;
        kinds[other] = static_cast<std::uint8_t>(3 - kinds[dart]);
        waiting.push_back(other);
      }
    }
  }
  for (std::uint8_t& kind : kinds) kind = kind == 1;
  return kinds;
}

}  // namespace

// Builds the surface of all free faces: one half-edge for each of their forward darts.
Boundary boundary_of(const Map& map, const Embedding& embedding) {
  const std::vector<std::uint8_t> forward = orientations(map);
  Boundary boundary;
  ClosedSurface& surface = boundary.surface;
  std::vector<std::uint32_t> half(map.darts(), none), darts;
  for (std::uint32_t first = 0; first < map.darts(); ++first) {
    if (!forward[first] || map.alpha(3, first) != first || half[first] != none) continue;
    std::uint32_t dart = first;
    do {
      half[dart] = static_cast<std::uint32_t>(darts.size());
      darts.push_back(dart);
      surface.face.push_back(surface.faces);
      dart = map.alpha(1, map.alpha(0, dart));
    } while (dart != first);
    boundary.volume.push_back(map.volume_of()[first]);
    boundary.face.push_back(map.face_of()[first]);
    ++surface.faces;
  }
  surface.origin.reserve(darts.size());
  surface.next.reserve(darts.size());
  surface.twin.reserve(darts.size());
  for (const std::uint32_t dart : darts) {
    surface.origin.push_back(embedding.vertex_of()[dart]);
    surface.next.push_back(half[map.alpha(1, map.alpha(0, dart))]);
    surface.twin.push_back(half[map.alpha(0, map.across_gap(dart))]);
  }
  surface.positions.assign(embedding.positions().begin(), embedding.positions().end());
  return boundary;
}

}  // namespace panicle::generalized_map
