// Finds the spheres that touch each other, and those that touch a stem: by a grid, four at a time, in time linear in
// their number where they are of like size.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "spatial/point_grid.hpp"
#include "spatial/sphere.hpp"

namespace panicle {

struct SpherePair {
  std::uint32_t a, b;
  bool operator==(const SpherePair&) const = default;
};

// Results are in ascending order of the spheres' indices and do not depend on the grid. Spheres that are not finite,
// those with a negative radius, and stems whose length's square is not finite touch nothing.
class SphereOverlapQuery {
 public:
  SphereOverlapQuery() = default;
  explicit SphereOverlapQuery(std::span<const Sphere> spheres) { build(spheres); }

  // Replaces all spheres; memory is reused.
  void build(std::span<const Sphere> spheres);

  // Appends all pairs a < b of spheres that touch or overlap, by a, then by b; stops once there are `most`.
  void pairs(std::vector<SpherePair>& found, std::size_t most = std::numeric_limits<std::size_t>::max());

  // The spheres that touch the straight stem from `start` to `end` of constant radius: a ball swept along it. Valid
  // until the next call.
  std::span<const std::uint32_t> along(const glm::vec3& start, const glm::vec3& end, float radius);

 private:
  void find_touching(const glm::vec3& start, const glm::vec3& way, float radius, std::uint32_t least);

  PointGrid grid_;
  float largest_ = 0;
  std::vector<glm::vec3> centres_;  // not a number where there is none
  std::vector<float> radii_;
  std::vector<float> x_, y_, z_, radius_;  // by slot, and three more
  std::vector<std::uint32_t> found_;
};

}  // namespace panicle
