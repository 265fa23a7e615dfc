// Obstacles for branches and roots: boxes, as a wall or a stone, and ellipsoids, as another tree's crown. No particle
// starts in them and no way passes them; places hidden behind them are reached round their edges.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

namespace panicle::particles {

struct Box {
  glm::vec3 low{0}, high{0};
};

// Whether a place is within the ellipsoid that fills a box.
bool within_round(const Box& box, const glm::vec3& p);

class Obstacles {
 public:
  static constexpr std::uint32_t most = 16;

  Obstacles() = default;
  // `margin`: added to their sizes, so that the drawn branches keep clear of them. `floor`, `ceiling`: heights between
  // which ways lead. `rounds`: the boxes that ellipsoids fill.
  Obstacles(std::span<const Box> boxes, std::span<const Box> rounds, float margin, float floor, float ceiling);
  Obstacles(std::span<const Box> boxes, float margin, float floor, float ceiling)
      : Obstacles(boxes, {}, margin, floor, ceiling) {}

  bool empty() const { return boxes_.empty() && rounds_.empty(); }
  // How far a way that passes the obstacles may be drawn sideways.
  float margin() const { return empty() ? std::numeric_limits<float>::max() : margin_; }
  bool contains(const glm::vec3& p) const;
  // Whether an obstacle meets the straight way from a to b.
  bool between(const glm::vec3& a, const glm::vec3& b) const;
  // Places to turn at, beside their edges.
  std::span<const glm::vec3> corners() const { return corners_; }

 private:
  std::vector<Box> boxes_, rounds_;
  std::vector<glm::vec3> corners_;
  float margin_ = 0;
};

}  // namespace panicle::particles
