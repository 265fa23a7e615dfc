// Coverage of a surface by leaves.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "spatial/closed_surface.hpp"
#include "spatial/point_grid.hpp"

namespace panicle::grammar {

struct Leaf {
  glm::vec3 base{0};
  float length = 0;
};

class LeafCoverage {
 public:
  explicit LeafCoverage(std::vector<Leaf> leaves);

  // The share of a surface that has the base of a leaf within that leaf's length: of about a thousand samples, evenly
  // dense. 0 for a surface without area.
  float share_of(const Surface& surface) const;

 private:
  bool reaches(const glm::vec3& place) const;

  std::vector<Leaf> leaves_;
  PointGrid grid_;
};

}  // namespace panicle::grammar
