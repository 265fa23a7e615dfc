#include "models/grammar/plate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "mesh/normals.hpp"

namespace panicle::grammar {
namespace {

// Corners nearer than this share of the sheet's size are one place.
constexpr float same_place = 1e-6f;
// Longest offset of a corner where the sheet bends, over half a thickness.
constexpr float max_mitre = 4;

using Edge = std::pair<std::uint32_t, std::uint32_t>;

// A grid of cells as wide as one place, with a list of corners in each cell, the last one first.
class Cells {
 public:
  Cells(std::span<const glm::vec3> corners, const glm::vec3& low, float size)
      : corners_(corners), low_(low), size_(size), before_(corners.size(), none) {}

  // Adds a corner to its cell. Returns an earlier corner at its place, or the corner itself. Neighbouring cells are
  // searched only for the first corner of a cell: all corners of one cell are one place.
  std::uint32_t put(std::uint32_t corner) {
    const Cell own = cell_of(corners_[corner]);
    std::uint32_t& last = last_.try_emplace(key_of(own), none).first->second;
    before_[corner] = last;
    last = corner;
    if (before_[corner] != none) return before_[corner];
    for (std::uint32_t around = 0; around < 27; ++around) {
      // Cells are counted from 1, so that the first has a neighbour before it.
      const auto found =
          last_.find(key_of({own[0] + around % 3 - 1, own[1] + around / 3 % 3 - 1, own[2] + around / 9 - 1}));
      for (std::uint32_t other = found == last_.end() ? none : found->second; other != none; other = before_[other])
        if (other != corner && is_one(corners_[other], corners_[corner])) return other;
    }
    return corner;
  }

 private:
  using Cell = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t none = 0xffffffff;

  // Places that are not a number, as in a box without size or too large for floats, are in the first cell.
  Cell cell_of(const glm::vec3& p) const {
    const glm::vec3 share = (p - low_) / size_;
    Cell cell{};
    for (int k = 0; k < 3; ++k)
      cell[static_cast<std::size_t>(k)] = 1 + (share[k] > 0 ? static_cast<std::uint32_t>(share[k] / same_place) : 0);
    return cell;
  }
  // One number for a cell's three indices, of 21 bits each.
  static std::uint64_t key_of(const Cell& cell) {
    return std::uint64_t{cell[0]} << 42 | std::uint64_t{cell[1]} << 21 | cell[2];
  }
  // Whether two corners are at one place.
  bool is_one(const glm::vec3& a, const glm::vec3& b) const {
    const glm::vec3 apart = glm::abs(a - b);
    return std::max({apart.x, apart.y, apart.z}) <= same_place * size_;
  }

  std::span<const glm::vec3> corners_;
  glm::vec3 low_;
  float size_;
  std::unordered_map<std::uint64_t, std::uint32_t> last_;  // by cell
  std::vector<std::uint32_t> before_;                      // by corner, of the same cell
};

// For each corner the first one at its place (or itself), so that triangles that meet there have edges with the same
// ends.
std::vector<std::uint32_t> places_of(std::span<const glm::vec3> corners, std::span<const std::uint32_t> triangles) {
  std::vector<std::uint32_t> used(triangles.begin(), triangles.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  glm::vec3 low = corners[used[0]], high = low;
  for (const std::uint32_t corner : used) {
    low = glm::min(low, corners[corner]);
    high = glm::max(high, corners[corner]);
  }
  const glm::vec3 size = high - low;
  const float extent = std::max({size.x, size.y, size.z});
  // Corners sorted along a direction that few sheets are square to: only corners next to each other in that order can
  // be at one place.
  const auto along = [&](std::uint32_t corner) { return glm::dot(corners[corner] - low, {0.61f, 0.47f, 0.64f}); };
  std::stable_sort(used.begin(), used.end(), [&](std::uint32_t a, std::uint32_t b) { return along(a) < along(b); });
  std::vector<std::uint32_t> place(corners.size());
  std::iota(place.begin(), place.end(), 0u);
  Cells cells(corners, low, extent);
  for (std::size_t i = 0, end = 0; i < used.size(); i = end) {
    for (end = i + 1; end < used.size() && along(used[end]) - along(used[end - 1]) <= 2 * same_place * extent;) ++end;
    for (std::size_t k = i; end - i > 1 && k < end; ++k) place[used[k]] = place[cells.put(used[k])];
  }
  return place;
}

// Edges that the triangles run through more often in this direction than back, repeated by the difference.
std::vector<Edge> rim_of(std::span<const std::uint32_t> triangles) {
  std::vector<Edge> edges;
  for (std::size_t k = 0; k < triangles.size(); ++k)
    edges.emplace_back(triangles[k], triangles[k % 3 == 2 ? k - 2 : k + 1]);
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> rim;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    end = static_cast<std::size_t>(
        std::upper_bound(edges.begin() + static_cast<std::ptrdiff_t>(i), edges.end(), edges[i]) - edges.begin());
    const auto back = std::equal_range(edges.begin(), edges.end(), Edge(edges[i].second, edges[i].first));
    const auto there = static_cast<std::ptrdiff_t>(end - i);
    rim.insert(rim.end(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(there - (back.second - back.first), 0)),
               edges[i]);
  }
  return rim;
}

}  // namespace

// The unit vector in the direction of `v`, or `otherwise` for a zero vector.
glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise) {
  const float size = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return size > 0 ? glm::normalize(v / size) : otherwise;
}

// Adds a plate of even thickness to a mesh: the sheet of triangles moved up and down by half of it, and walls along its
// rim. `from` receives the sheet's corner of each vertex.
void add_plate(Mesh& mesh, std::span<const glm::vec3> corners, std::span<const std::uint32_t> triangles,
               float thickness, std::vector<std::uint32_t>& from) {
  if (triangles.empty()) return;
  const std::vector<std::uint32_t> place = places_of(corners, triangles);
  std::vector<std::uint32_t> valid;
  for (std::size_t k = 0; k < triangles.size(); k += 3) {
    const std::uint32_t a = place[triangles[k]], b = place[triangles[k + 1]], c = place[triangles[k + 2]];
    if (a != b && b != c && c != a) valid.insert(valid.end(), {a, b, c});
  }
  // Sums of the triangles' areas at each corner, as vectors and as lengths.
  std::vector<glm::vec3> sums(corners.size(), glm::vec3(0));
  std::vector<float> areas(corners.size(), 0);
  glm::vec3 whole(0);
  for (std::size_t k = 0; k < valid.size(); k += 3) {
    const glm::vec3 twice = triangle_normal(corners[valid[k]], corners[valid[k + 1]], corners[valid[k + 2]]);
    for (std::size_t m = 0; m < 3; ++m) {
      sums[valid[k + m]] += twice;
      areas[valid[k + m]] += glm::length(twice);
    }
    whole += twice;
  }
  const glm::vec3 mean = unit_or(whole, {0, 0, 1});
  // Adds a vertex on one side of the plate. The mitre preserves the thickness where triangles meet at an angle.
  const auto add = [&](std::uint32_t corner, float side, const glm::vec3& normal) {
    const float length = glm::length(sums[corner]);
    const float mitre = length > 0 ? std::min(areas[corner] / length, max_mitre) : 1;
    put(mesh.positions, corners[corner] + 0.5f * side * thickness * mitre * unit_or(sums[corner], mean));
    put(mesh.normals, normal);
    from.push_back(corner);
    return static_cast<std::uint32_t>(mesh.positions.size() / 3 - 1);
  };
  // The upper and the lower face, then walls along the rim.
  for (const float side : {1.0f, -1.0f}) {
    std::vector<std::uint32_t> number(corners.size(), 0);
    for (std::uint32_t corner = 0; corner < corners.size(); ++corner)
      if (areas[corner] > 0) number[corner] = add(corner, side, side * unit_or(sums[corner], mean));
    for (std::size_t k = 0; k < valid.size(); k += 3)
      put(mesh.indices, number[valid[k]], number[valid[k + (side > 0 ? 1 : 2)]], number[valid[k + (side > 0 ? 2 : 1)]]);
  }
  for (const auto& [a, b] : rim_of(valid)) {
    const glm::vec3 up = unit_or(sums[a], mean) + unit_or(sums[b], mean);
    const glm::vec3 out = unit_or(glm::cross(corners[b] - corners[a], up), mean);
    const std::uint32_t top = add(a, 1, out), far_top = add(b, 1, out), low = add(a, -1, out),
                        far_low = add(b, -1, out);
    put(mesh.indices, top, low, far_low);
    put(mesh.indices, top, far_low, far_top);
  }
}

}  // namespace panicle::grammar
