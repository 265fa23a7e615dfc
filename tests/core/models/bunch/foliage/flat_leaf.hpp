// A flat leaf of five lobes about a petiole sinus, for the tests to bend: rings of vertices about the petiole's point.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "foliage/flat_leaf.hpp"

namespace panicle::tests {

struct LeafNumbers {
  std::vector<float> points, between, uvs;
  std::vector<std::uint32_t> triangles;
  std::vector<float> petiole = {};

  FlatLeaf view() const { return {points, between, uvs, triangles, petiole}; }
};

inline constexpr std::uint32_t flat_leaf_rings = 9, flat_leaf_parts = 60;

inline LeafNumbers make_flat_leaf() {
  LeafNumbers leaf;
  const auto add = [&leaf](double x, double y, double between) {
    leaf.points.insert(leaf.points.end(), {static_cast<float>(x), static_cast<float>(y)});
    leaf.between.push_back(static_cast<float>(between));
    leaf.uvs.insert(leaf.uvs.end(), {static_cast<float>(0.5 + 0.4 * x), static_cast<float>(0.6 - 0.4 * y)});
  };
  add(0, 0, 0);
  for (std::uint32_t ring = 1; ring <= flat_leaf_rings; ++ring) {
    for (std::uint32_t k = 0; k <= flat_leaf_parts; ++k) {
      const double degrees = -162 + 324.0 * k / flat_leaf_parts, angle = degrees * 3.14159265358979 / 180;
      const double lobe = std::fabs(std::cos(3.33 * angle));  // 1 on a main vein
      const double reach = (0.72 + 0.28 * lobe) * (1 - 0.3 * std::fabs(degrees) / 162) * ring / flat_leaf_rings;
      add(reach * std::sin(angle), reach * std::cos(angle), 1 - lobe);
    }
  }
  const auto at = [](std::uint32_t ring, std::uint32_t k) { return 1 + (ring - 1) * (flat_leaf_parts + 1) + k; };
  for (std::uint32_t k = 0; k < flat_leaf_parts; ++k) {
    leaf.triangles.insert(leaf.triangles.end(), {0, at(1, k + 1), at(1, k)});
    for (std::uint32_t ring = 1; ring < flat_leaf_rings; ++ring) {
      leaf.triangles.insert(leaf.triangles.end(), {at(ring, k), at(ring, k + 1), at(ring + 1, k)});
      leaf.triangles.insert(leaf.triangles.end(), {at(ring, k + 1), at(ring + 1, k + 1), at(ring + 1, k)});
    }
  }
  return leaf;
}

inline FlatLeaf flat_leaf() {
  static const LeafNumbers leaf = make_flat_leaf();
  return leaf.view();
}

}  // namespace panicle::tests
