#include "models/grammar/plate.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

namespace panicle::grammar {
namespace {

// Of the sheet's size: what is nearer is one place.
constexpr float same_place = 1e-6f;
// How much farther than half a thickness a corner may stand out where the sheet bends.
constexpr float most_mitre = 4;

using Edge = std::pair<std::uint32_t, std::uint32_t>;

// Of each corner the first one that stands at its place: ways there and back are one way.
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
  const float near = same_place * std::max({size.x, size.y, size.z});
  // By how far they are along a way that no row of corners is likely to stand square to.
  const auto along = [&](std::uint32_t corner) { return glm::dot(corners[corner] - low, {0.61f, 0.47f, 0.64f}); };
  std::stable_sort(used.begin(), used.end(), [&](std::uint32_t a, std::uint32_t b) { return along(a) < along(b); });
  std::vector<std::uint32_t> place(corners.size());
  std::iota(place.begin(), place.end(), 0u);
  for (std::size_t i = 0; i < used.size(); ++i)
    for (std::size_t k = i; k-- > 0 && along(used[i]) - along(used[k]) <= 2 * near;) {
      const glm::vec3 apart = glm::abs(corners[used[i]] - corners[used[k]]);
      if (std::max({apart.x, apart.y, apart.z}) > near) continue;
      place[used[i]] = place[used[k]];
      break;
    }
  return place;
}

// Edges that the triangles run through more often this way than back, each as often as that.
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

glm::vec3 unit(const glm::vec3& v, const glm::vec3& otherwise) {
  const float size = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return size > 0 ? glm::normalize(v / size) : otherwise;
}

}  // namespace

void add_plate(Mesh& mesh, std::span<const glm::vec3> corners, std::span<const std::uint32_t> given, float thickness,
               std::vector<std::uint32_t>& from) {
  if (given.empty()) return;
  const std::vector<std::uint32_t> place = places_of(corners, given);
  std::vector<std::uint32_t> triangles;
  for (std::size_t k = 0; k < given.size(); k += 3) {
    const std::uint32_t a = place[given[k]], b = place[given[k + 1]], c = place[given[k + 2]];
    if (a != b && b != c && c != a) triangles.insert(triangles.end(), {a, b, c});
  }
  // Of each corner the sum of its triangles' areas, with and without their turn.
  std::vector<glm::vec3> sums(corners.size(), glm::vec3(0));
  std::vector<float> areas(corners.size(), 0);
  glm::vec3 whole(0);
  for (std::size_t k = 0; k < triangles.size(); k += 3) {
    const glm::vec3 &a = corners[triangles[k]], &b = corners[triangles[k + 1]], &c = corners[triangles[k + 2]];
    const glm::vec3 twice = glm::cross(b - a, c - a);
    for (std::size_t m = 0; m < 3; ++m) {
      sums[triangles[k + m]] += twice;
      areas[triangles[k + m]] += glm::length(twice);
    }
    whole += twice;
  }
  const glm::vec3 mean = unit(whole, {0, 0, 1});
  const auto add = [&](std::uint32_t corner, float side, const glm::vec3& normal) {
    const float length = glm::length(sums[corner]);
    const float mitre = length > 0 ? std::min(areas[corner] / length, most_mitre) : 1;
    put(mesh.positions, corners[corner] + 0.5f * side * thickness * mitre * unit(sums[corner], mean));
    put(mesh.normals, normal);
    from.push_back(corner);
    return static_cast<std::uint32_t>(mesh.positions.size() / 3 - 1);
  };
  for (const float side : {1.0f, -1.0f}) {
    std::vector<std::uint32_t> number(corners.size(), 0);
    for (std::uint32_t corner = 0; corner < corners.size(); ++corner)
      if (areas[corner] > 0) number[corner] = add(corner, side, side * unit(sums[corner], mean));
    for (std::size_t k = 0; k < triangles.size(); k += 3)
      put(mesh.indices, number[triangles[k]], number[triangles[k + (side > 0 ? 1 : 2)]],
          number[triangles[k + (side > 0 ? 2 : 1)]]);
  }
  for (const auto& [a, b] : rim_of(triangles)) {
    const glm::vec3 up = unit(sums[a], mean) + unit(sums[b], mean);
    const glm::vec3 out = unit(glm::cross(corners[b] - corners[a], up), mean);
    const std::uint32_t top = add(a, 1, out), far_top = add(b, 1, out), low = add(a, -1, out),
                        far_low = add(b, -1, out);
    put(mesh.indices, top, low, far_low);
    put(mesh.indices, top, far_low, far_top);
  }
}

}  // namespace panicle::grammar
