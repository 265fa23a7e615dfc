// Nearest neighbours and close pairs among points that change at every step.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/particles/guide.hpp"
#include "spatial/point_grid.hpp"

namespace panicle::particles {

struct Pair {
  float square;  // of the distance
  std::uint32_t a, b;
};

class Neighbours {
 public:
  static constexpr std::uint32_t none = ~0u;

  // Replaces the points; memory is reused. The points must outlive all queries.
  void build(std::span<const glm::vec3> points);

  // The other point nearest to point `i` among those visible from it: of equally near ones the one with the lowest
  // index; `none` if there is no other within `reach`.
  std::uint32_t nearest(std::uint32_t i, float reach, const Guide& guide) const;

  // Appends all pairs a < b closer than `reach`, in unspecified order.
  void pairs(float reach, std::vector<Pair>& found) const;

 private:
  std::span<const glm::vec3> points_;
  float edge_ = 0;
  float across_ = 0;  // at least the diagonal of the points' box
  PointGrid grid_;
  std::vector<float> x_, y_, z_;  // by slot, and three more for SIMD
};

}  // namespace panicle::particles
