#include "models/flower/organ_corners.hpp"

#include <algorithm>

#include "foundation/bytes.hpp"
#include "models/flower/ranks.hpp"

namespace panicle::flower {

// Numbers the corners of organs: all half-edges of one organ that leave one vertex share a corner.
OrganCorners::OrganCorners(const Derived& derived, const ClosedSurface& surface,
                           const std::vector<std::uint32_t>& volume) {
  volume_.reserve(surface.half_edges());
  for (const std::uint32_t face : surface.face) volume_.push_back(volume[face]);
  // Half-edges sorted by their origins, so that those of a vertex are consecutive.
  std::vector<std::uint32_t> end(surface.positions.size() + 1, 0), about(surface.half_edges());
  for (const std::uint32_t vertex : surface.origin) ++end[vertex + 1];
  for (std::size_t v = 1; v < end.size(); ++v) end[v] += end[v - 1];
  for (std::uint32_t h = 0; h < surface.half_edges(); ++h) about[end[surface.origin[h]]++] = h;

  // Of each organ the last vertex with a corner, and that corner.
  std::vector<std::uint32_t> last(derived.instances.size(), invalid), own(derived.instances.size(), invalid);
  corner_.resize(surface.half_edges());
  for (const std::uint32_t h : about) {
    const std::uint32_t organ = derived.records[derived.record_of[volume_[h]]].instance;
    if (last[organ] != surface.origin[h]) {
      last[organ] = surface.origin[h];
      own[organ] = corners_++;
    }
    corner_[h] = own[organ];
  }
}

// The position in its organ of each half-edge's corner: the mean along the organ and the least distance from its middle
// line.
std::vector<glm::vec2> OrganCorners::places(const Derived& derived) const {
  struct Corner {
    float along = 0, beside = 1, count = 0;
  };
  const std::vector<glm::vec2> of_volume = organ_coordinates(derived);
  std::vector<Corner> corners(corners_);
  for (std::uint32_t h = 0; h < corner_.size(); ++h) {
    Corner& corner = corners[corner_[h]];
    const glm::vec2& place = of_volume[volume_[h]];
    corner.along += place.x;
    corner.beside = std::min(corner.beside, place.y);
    ++corner.count;
  }
  std::vector<glm::vec2> places;
  places.reserve(corner_.size());
  for (const std::uint32_t each : corner_) {
    const Corner& corner = corners[each];
    places.push_back({corner.along / corner.count, corner.beside});
  }
  return places;
}

// The memory that it holds, roughly.
std::uint64_t OrganCorners::bytes() const { return bytes_of(volume_) + bytes_of(corner_); }

// Computes the four places that each half-edge has on the refined surface: its own, the middles of its edge and of its
// face, and the middle of the edge before.
std::vector<glm::vec2> refined_places(const ClosedSurface& surface, const std::vector<glm::vec2>& places) {
  std::vector<glm::vec3> sums(surface.faces, glm::vec3(0));
  std::vector<glm::vec2> fine(4 * places.size());
  for (std::uint32_t h = 0; h < places.size(); ++h) {
    const std::uint32_t next = surface.next[h];
    sums[surface.face[h]] += glm::vec3(places[h], 1);
    fine[4 * h] = places[h];
    fine[4 * h + 1] = fine[4 * next + 3] = 0.5f * (places[h] + places[next]);
  }
  for (std::uint32_t h = 0; h < places.size(); ++h) {
    const glm::vec3& sum = sums[surface.face[h]];
    fine[4 * h + 2] = {sum.x / sum.z, sum.y / sum.z};
  }
  return fine;
}

}  // namespace panicle::flower
