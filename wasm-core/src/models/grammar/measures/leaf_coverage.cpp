#include "models/grammar/measures/leaf_coverage.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <utility>

#include "mesh/normals.hpp"

namespace panicle::grammar {
namespace {

constexpr double places = 1000;
// Steps of an additive recurrence in two dimensions (Roberts 2018).
constexpr double across = 0.7548776662, along = 0.569840291;

// The fractional part.
double fraction_of(double x) { return x - std::floor(x); }

}  // namespace

// Sorts the leaves into a grid by their bases.
LeafCoverage::LeafCoverage(std::vector<Leaf> leaves) : leaves_(std::move(leaves)) {
  std::vector<glm::vec3> bases;
  float longest = 0;
  for (const Leaf& leaf : leaves_) {
    bases.push_back(leaf.base);
    longest = std::max(longest, leaf.length);
  }
  if (longest > 0) grid_.build(bases, longest);
}

// Whether a place is no farther from a leaf's base than the leaf is long.
bool LeafCoverage::reaches(const glm::vec3& place) const {
  bool found = false;
  grid_.visit(place, [&](std::uint32_t i) {
    const glm::vec3 way = leaves_[i].base - place;
    found = found || glm::dot(way, way) <= leaves_[i].length * leaves_[i].length;
  });
  return found;
}

// The share of a surface, 0 … 1, that leaves reach: of about 1000 points spread evenly over it.
float LeafCoverage::share_of(const Surface& surface) const {
  const std::vector<std::uint32_t>& corners = surface.triangles;
  const auto corner = [&](std::size_t i) -> const glm::vec3& { return surface.points[corners[i]]; };
  const auto area = [&](std::size_t i) {
    return static_cast<double>(glm::length(triangle_normal(corner(i), corner(i + 1), corner(i + 2))));
  };
  double whole = 0, done = 0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) whole += area(i);
  if (!(whole > 0)) return 0;
  std::size_t sampled = 0, clothed = 0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    done += area(i);
    // Each triangle gets samples in proportion to its area; those beyond its diagonal are folded into it.
    for (const double until = std::floor(places * done / whole + 0.5); static_cast<double>(sampled) < until;
         ++sampled) {
      double u = fraction_of(0.5 + across * static_cast<double>(sampled)),
             v = fraction_of(0.5 + along * static_cast<double>(sampled));
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      clothed += reaches(corner(i) + static_cast<float>(u) * (corner(i + 1) - corner(i)) +
                         static_cast<float>(v) * (corner(i + 2) - corner(i)))
                     ? 1
                     : 0;
    }
  }
  return sampled > 0 ? static_cast<float>(clothed) / static_cast<float>(sampled) : 0;
}

}  // namespace panicle::grammar
